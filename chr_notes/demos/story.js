/**
 * A guided tour through a demo's states: `[{ says, state, seconds }]`.
 *
 * Played, it glides from state to state and waits at each one so that its sentence can be read.
 * Where the reader's system asks for less motion nothing glides: each press is one step.
 */

const WAIT = 3500; // milliseconds at each state
const MOVE = 2; // seconds from state to state, unless the story says otherwise

/** True where the reader's system asks for less motion. */
const stillness = () => matchMedia("(prefers-reduced-motion: reduce)");

/**
 * Go from one state to another, or be there at once where motion is not wanted. `between(from,
 * to, t)` gives the states on the way, which `changed` is told of as moving. Returns a function
 * that ends the journey where it is.
 */
export function glide(from, goal, seconds, { between, changed, done = () => {} }) {
  if (stillness().matches) {
    changed(goal);
    done();
    return () => {};
  }
  const began = performance.now();
  let frame = requestAnimationFrame(function step(now) {
    const t = Math.min(1, Math.max(0, (now - began) / (1000 * seconds)));
    changed(t === 1 ? goal : between(from, goal, t * t * (3 - 2 * t)), t < 1);
    if (t < 1) frame = requestAnimationFrame(step);
    else done();
  });
  return () => cancelAnimationFrame(frame);
}

/**
 * Tell a story: `current()` is the state now, `changed(state)` shows another, `say(text)` a
 * sentence, `name(text)` names the button whose every click calls `press`, and `stopped()` is told
 * of each end. `signal` ends it.
 */
export function player(story, { current, between, changed, say, name, stopped, signal }) {
  let next = 0; // index of the step to come
  let running = false;
  let end = () => {};

  function rename() {
    if (running) name("Pause");
    else if (stillness().matches) name(next === 0 ? "Show me, step by step" : "Next step");
    else name(next === 0 ? "Play" : "Go on");
  }

  function stop() {
    end();
    end = () => {};
    running = false;
    rename();
    stopped();
  }

  function step() {
    const index = next;
    const { says, state, seconds = MOVE } = story[index];
    say(says);
    const done = () => {
      next = (index + 1) % story.length;
      if (!running || next === 0) return stop();
      const timer = setTimeout(step, WAIT);
      end = () => clearTimeout(timer);
      return undefined;
    };
    end = glide(current(), state, seconds, { between, changed, done });
  }

  rename();
  stillness().addEventListener("change", stop, { signal });
  return {
    stop,
    press() {
      if (running) return stop();
      running = !stillness().matches;
      step();
      rename();
      return undefined;
    },
    rewind() {
      next = 0;
      say("");
      stop();
    },
  };
}
