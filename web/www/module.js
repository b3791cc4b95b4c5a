// The module and what it shows: the layouts are those of `ArmView`, `BallsView`, `EyeView` and `ControlView`.

export const ARMS = ["hybrid", "graph", "network", "planner"];
export const STATES = ["graph", "network", "planner", "reached", "stop", "cycle", "joint limit", "collision", "time limit"];
export const REACHED = 3;

export async function load(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status}`);
  const { instance } = await WebAssembly.instantiate(await answer.arrayBuffer(), {});
  return wrap(instance.exports);
}

/** Wraps the module's exports: one object for the arms, one for those among balls, one for the camera, one for each problem. */
export function wrap(exports) {
  // The memory may have grown since the last call: the buffer is asked for each time.
  const at = (place, length) => new DataView(exports.memory.buffer, place, length);
  const arms = {
    aim: (x, y, z) => exports.tpg_arm_aim(x, y, z),
    home: () => exports.tpg_arm_home(),
    gather: () => exports.tpg_arm_gather(),
    act: (arm, count) => exports.tpg_arm_act(arm, count),
    view(arm) {
      const place = exports.tpg_arm_view(arm);
      if (place === 0) throw new Error("the network in the module is damaged");
      const data = at(place, 112), float = offset => data.getFloat32(offset, true), word = offset => data.getUint32(offset, true);
      return {
        points: [0, 1, 2, 3, 4].map(point => [0, 4, 8].map(part => float(12 * point + part))),
        distance: float(60),
        pose: [64, 68, 72, 76].map(offset => data.getInt32(offset, true)),
        actions: [word(80), word(84)],
        state: word(88),
        seen: [92, 96, 100, 104, 108].map(float),
      };
    },
  };
  const balls = {
    begin({ bytes }) {
      const place = exports.tpg_balls_scene(bytes.length);
      new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
      exports.tpg_balls_begin();
    },
    act: arm => exports.tpg_balls_act(arm),
    view(arm) {
      const data = at(exports.tpg_balls_view(arm), 132), float = offset => data.getFloat32(offset, true), word = offset => data.getUint32(offset, true);
      const triple = place => [0, 4, 8].map(part => float(place + part));
      return {
        points: [0, 1, 2, 3, 4].map(point => triple(12 * point)),
        balls: [0, 1, 2].map(ball => ({ at: triple(60 + 16 * ball), radius: float(72 + 16 * ball) })).slice(0, word(108)),
        distance: float(112), clearance: float(116), steps: word(120), behaviour: word(124), state: word(128),
      };
    },
  };
  const eye = {
    restart: seed => exports.tpg_eye_restart(seed),
    act: () => exports.tpg_eye_act(),
    drag: (down, right) => exports.tpg_eye_drag(down, right),
    view() {
      const place = exports.tpg_eye_view(), data = at(place, 812), float = offset => data.getFloat32(offset, true);
      return {
        pixels: new Uint8Array(exports.memory.buffer, place, 768),
        seen: [768, 772, 776, 780, 784, 788].map(float), action: [792, 796].map(float), ball: [800, 804].map(float),
        ended: data.getUint32(808, true) === 1,
      };
    },
  };
  const problem = number => ({
    restart: seed => exports.tpg_control_restart(number, seed),
    act: () => exports.tpg_control_act(number),
    push: (value, by) => exports.tpg_control_push(number, value, by),
    set: (constant, to) => exports.tpg_control_set(number, constant, to),
    view() {
      const data = at(exports.tpg_control_view(number), 80), double = offset => data.getFloat64(offset, true);
      return {
        state: [0, 8, 16, 24].map(double),
        action: double(32), score: double(40), lastScore: double(48),
        seen: [56, 60, 64, 68].map(offset => data.getFloat32(offset, true)),
        actions: data.getUint32(72, true), ended: data.getUint32(76, true) === 1,
      };
    },
  });
  return { arms, balls, eye, problems: [0, 1, 2].map(problem) };
}
