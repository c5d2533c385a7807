/** The demos of the chapters, by the name of their elements. */
import { mount as drift } from "./drift.js";
import { mount as filter } from "./filter.js";
import { mount as frames } from "./frames.js";
import { mount as gimbalLock } from "./gimbal_lock.js";
import { mount as magnetometer } from "./magnetometer.js";
import { mount as quaternion } from "./quaternion.js";
import { mount as tilt } from "./tilt.js";
import { mount as validation } from "./validation.js";

export const DEMOS = { drift, filter, frames, "gimbal-lock": gimbalLock, magnetometer, quaternion, tilt, validation };
