/** Directions spread evenly over the sphere, along a spiral by the golden angle. */
export const evenlySpread = (count) =>
  Array.from({ length: count }, (_, i) => {
    const height = 1 - (2 * i + 1) / count;
    const turn = Math.PI * (3 - Math.sqrt(5)) * i;
    const radius = Math.sqrt(1 - height * height);
    return [radius * Math.cos(turn), radius * Math.sin(turn), height];
  });
