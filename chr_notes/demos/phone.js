/**
 * The phone in the reader's hand as the sensor of the tilt demo. Its readings stay in the page.
 *
 * Browsers give axes as x right, y to the top and z out of the screen, and rates about the same as
 * alpha, beta and gamma. Forward is here to the top, down is into the screen. The acceleration has
 * one sign on Android, as an accelerometer reads it, and the other on iOS.
 */
import { accelerometerAtRest, tiltFromAccelerometer } from "../generated/javascript/attitude.mjs";
import { scaled, sum } from "./draw.js";
import { node, rounded } from "./parts.js";

/* global STANDARD_GRAVITY: build.py puts it in, m/s² */

const [SILENT, EVERY, AVERAGED, LONGEST] = [2000, 100, 15, 36000]; // milliseconds, milliseconds, readings, readings
const SLANTED = 0.3; // of gravity, across: more is not flat
const COLUMNS = ["time_s", ...["accel_N_m/s2", "gyro_N_deg/s"].flatMap((name) => ["x", "y", "z"].map((axis) => name.replace("N", axis)))];
const INSECURE = "A browser gives its sensors only to pages that came over https, and this one did not. The sliders do without.";
const DENIED = "The permission was denied, so the demo stays with its sliders. It can be given in the settings of the browser.";
const ABSENT = "No reading comes: this device, or this browser, has no accelerometer for a page.";
const FLAT = "Lay the phone flat on a table, its screen up, and press “It lies flat”. Phones differ in their signs, and this settles them.";

/** The button and what it leads to; `put(state)` moves the demo, and `signal` ends it all. */
export function phone({ put, signal }) {
  let [sign, silence, shown, rows, recent] = [1, 0, 0, null, []];
  const said = node("p", { class: "chr-phone", role: "status" });
  const reading = node("p", { class: "chr-phone" });
  const button = (name, words, press) => {
    const made = node("button", { type: "button", name }, words);
    made.addEventListener("click", press);
    return made;
  };
  const start = button("phone", "Use this phone", ask);
  const flat = button("flat", "It lies flat", settle);
  const record = button("record", "Record", toggle);
  const tell = (words) => (said.textContent = words);
  const offer = (...which) => [start, flat, record].forEach((each) => (each.hidden = !which.includes(each)));
  const mean = () => scaled(recent.reduce(sum), 1 / recent.length);

  async function ask() {
    if (!isSecureContext) return tell(INSECURE);
    if (!window.DeviceMotionEvent) return tell(ABSENT);
    const given = await (DeviceMotionEvent.requestPermission?.().catch(() => "denied") ?? "granted");
    if (given !== "granted") return tell(DENIED);
    addEventListener("devicemotion", heard, { signal });
    silence = setTimeout(() => (tell(ABSENT), offer(start)), SILENT);
    offer(flat);
    return tell(FLAT);
  }

  function heard({ accelerationIncludingGravity: force, rotationRate: rate, timeStamp }) {
    if (typeof force?.x !== "number") return;
    clearTimeout(silence);
    recent = [...recent.slice(1 - AVERAGED), [force.y, force.x, -force.z]];
    const turning = typeof rate?.alpha === "number" ? [rate.beta, rate.alpha, -rate.gamma] : [];
    if (rows?.length < LONGEST) rows.push([timeStamp / 1000, ...scaled(recent.at(-1), sign), ...turning]);
    if (record.hidden || timeStamp - shown < EVERY) return;
    shown = timeStamp;
    show(scaled(mean(), sign));
  }

  function show(force) {
    const [roll, pitch] = tiltFromAccelerometer(...force);
    const left = Math.hypot(...sum(force, scaled(accelerometerAtRest(roll, pitch, STANDARD_GRAVITY), -1)));
    reading.textContent = `The phone reads (${force.map(rounded).join(", ")}) m/s². What the formula gives for these angles at rest is ${rounded(left)} m/s² away.`;
    const [phi, theta] = [roll, pitch].map((angle) => Number(((angle * 180) / Math.PI).toFixed(1)) + 0);
    put({ roll: phi, pitch: theta, forward_acceleration: 0, lateral_acceleration: 0, vibration: 0 });
  }

  function settle() {
    const [ahead, right, down] = recent.length > 0 ? mean() : [1, 1, 1];
    if (Math.hypot(ahead, right) > SLANTED * Math.abs(down)) return tell(`It does not lie flat yet. ${FLAT}`);
    sign = down > 0 ? -1 : 1;
    offer(record);
    return tell("Now tilt it: the aircraft does the same, its nose to the top of the phone. Then shake it. What you record stays on this phone.");
  }

  function toggle() {
    if (rows === null) {
      rows = [];
      record.textContent = "Stop and save";
      return;
    }
    const lines = rows.map(([time, ...values]) => [time - rows[0][0], ...values].map((value) => value.toFixed(4)).join(","));
    const names = COLUMNS.slice(0, rows[0]?.length);
    const href = URL.createObjectURL(new Blob([[names.join(","), ...lines, ""].join("\n")], { type: "text/csv" }));
    node("a", { href, download: "phone.csv" }).click();
    setTimeout(() => URL.revokeObjectURL(href), SILENT);
    tell(`Saved ${rows.length} readings as phone.csv; read_log("phone.csv") reads it.`);
    rows = null;
    record.textContent = "Record";
  }

  offer(start);
  return [start, flat, record, said, reading];
}
