/** Keep what a function last made, for as long as the values of some names stay. */
export function keeping(names, make) {
  let [key, made] = [null, null];
  return (state) => {
    const now = names.map((name) => state[name]).join();
    if (now !== key) [key, made] = [now, make(state)];
    return made;
  };
}
