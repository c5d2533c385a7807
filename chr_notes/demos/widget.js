/** What anywidget asks of a module: a model whose traits follow the demo, and the reverse. */

const SYNC_EVERY = 200; // milliseconds: a kernel need not see each frame of what plays

/**
 * The first call goes to `send` at once; of those that follow, the last one of each interval.
 * `end()` sends what still waits.
 */
function paced(send, interval) {
  let timer = 0;
  let waiting = null;
  function flush() {
    clearTimeout(timer);
    timer = 0;
    if (waiting === null) return;
    const state = waiting;
    waiting = null;
    timer = setTimeout(flush, interval);
    send(state);
  }
  return {
    push(state) {
      waiting = state;
      if (timer === 0) flush();
    },
    end() {
      flush();
      clearTimeout(timer);
    },
  };
}

export const widget = (mount) => ({
  render({ model, el }) {
    const names = Object.keys(mount.start);
    const state = () => Object.fromEntries(names.map((name) => [name, model.get(name)]));
    let own = false; // the model tells of our changes as well
    const sync = paced((changed) => {
      own = true;
      names.forEach((name) => model.set(name, changed[name]));
      own = false;
      model.save_changes();
    }, SYNC_EVERY);
    const demo = mount(el, state(), { onChange: sync.push });
    const follow = () => own || demo.update(state());
    names.forEach((name) => model.on(`change:${name}`, follow));
    return () => {
      names.forEach((name) => model.off(`change:${name}`, follow));
      demo.destroy();
      sync.end();
    };
  },
});
