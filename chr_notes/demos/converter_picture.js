/** The converter's picture: one aircraft twice, with the axes of the one system and of the other. */
import { inPart, line, words } from "./chart.js";
import { turnNames } from "./converting.js";
import { computed } from "./converter_state.js";
import { label as written, scaled, times, toParent, transposed } from "./draw.js";
import { beyond, flown, globe, looking, namesRound, pointer } from "./globe.js";

const UNITS = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const BODY = ["x", "y", "z"];
const ROOM = ["X", "Y", "Z"];

/** Both halves. */
export function draw(context, { width, height }, state, colours, viewpoint) {
  const { source, target, own } = computed(state);
  const half = width / 2;
  // The aircraft is drawn in north-east-down and forward-right-down, as the pictures of this book.
  const attitude = times(source.body, times(own, transposed(source.navigation)));
  [source, target].forEach((convention, i) =>
    inPart(context, [i * half, 0, half, height], (size) => scene(context, size, convention, attitude, colours, viewpoint)),
  );
  line(context, [[half, 10], [half, height - 10]], { colour: colours("line"), width: 1 });
}

function scene(context, size, { label, navigation, body }, attitude, colours, viewpoint) {
  const view = looking(viewpoint, size, 3.1);
  const taken = [];
  const style = { colours, room: size, taken };
  const column = (m, k) => [m[k], m[3 + k], m[6 + k]];
  words(context, label, [size.width / 2, 14], { colour: colours("muted"), align: "center", weight: 600 });
  globe(context, view, colours, size, { radius: 1.15, names: [] });
  const axes = UNITS.map((_, k) => scaled(column(navigation, k), 0.7));
  axes.forEach((axis) => pointer(context, view, axis, { ...style, colour: "muted", width: 1.5 }));
  flown(context, view, attitude, colours, 0.8);
  UNITS.forEach((_, k) =>
    pointer(context, view, toParent(attitude, column(body, k)), { ...style, name: [BODY[k]], colour: BODY[k], width: 3 }),
  );
  // Names come last, or an arrow that points their way would cover them.
  axes.forEach((axis, k) =>
    written(context, [ROOM[k]], beyond(...[[0, 0, 0], axis].map(view.project)), { colour: colours("muted"), rim: colours("page"), size: 13, ...size, taken }),
  );
  namesRound(context, view, colours, size, { radius: 1.15, taken });
}

/** The picture in words. */
export function describe(state) {
  const { source, target, here } = computed(state);
  const names = turnNames(source).map((name, i) => `${name} ${Number(here.angles[i].toFixed(3))}`);
  const axes = ({ label, along }) => `of ${label}, where x points ${along[0]}, y ${along[1]}, z ${along[2]}`;
  const unit = source.degrees ? "degrees" : "radians";
  return `One aircraft twice: with the axes ${axes(source)}, and with those ${axes(target)}. By ${source.label} its angles are ${names.join(", ")}, ${unit}.`.replaceAll("-", "−");
}
