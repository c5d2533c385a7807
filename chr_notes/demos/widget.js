/** What anywidget asks of a module: a model whose traits follow the demo, and the reverse. */
export const widget = (mount) => ({
  render({ model, el }) {
    const names = Object.keys(mount.start);
    const state = () => Object.fromEntries(names.map((name) => [name, model.get(name)]));
    const demo = mount(el, state(), (changed) => {
      names.forEach((name) => model.set(name, changed[name]));
      model.save_changes();
    });
    const follow = () => demo.update(state());
    names.forEach((name) => model.on(`change:${name}`, follow));
    return () => {
      names.forEach((name) => model.off(`change:${name}`, follow));
      demo.destroy();
    };
  },
});
