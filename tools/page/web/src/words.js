// Everything that the script shows, in English; the page may bring the words of another language.

const ENGLISH = {
  rapid: 'rapid',
  feed: 'feed',
  skip: 'skip move',
  collision: 'collision',
  touch: 'touch {n}',
  latched: 'latched ',
  now_aria: '{time} s, {kind}, {file} line {line}',
  now_aria_unplaced: '{time} s, {kind}',
  play: 'Play, space bar',
  pause: 'Pause, space bar',
  copied: 'Copied',
  timeline_touches: 'Touches',
  timeline_calls: 'Calls',
  timeline_motion: 'Motion',
  timeline_aria: 'Time line of {time} seconds: touches, calls, kinds of motion, axis positions',
  timeline_empty: 'Nothing moved: there is no time to show.',
  collision_at: 'collision, {time} s',
  plan_view: 'Plan view',
  plan_part: 'Part',
  plan_plane: 'Plane',
  plan_true_size: 'ball true size',
  plan_magnified: 'ball true size, deviations × {mag}',
  plan_aria: 'Plan view of {part}: outline, touches and magnified deviations. All values are in the touch table.',
  plan_empty: 'No touch and no collision lies on a part that is drawn.',
  own_deviation: 'the part’s own deviation',
  measured_adds: 'how much too deep the ball was latched, before any calibration',
  measured_circle: 'circle through what was latched, before any calibration: off the true one by {u} {du} {v} {dv} µm, diameter {dd} µm',
  tolerance_of_size: 'tolerance of size',
  probing_direction: 'probing direction',
  thin_does_not_count: 'thin: first touch, does not count',
  part_frame: 'part frame',
  section_at: 'section at {axis} {height} mm',
  where_wall_is: 'where the wall is',
  origin_of: 'origin of {frame}',
  broke_off: 'the move that was broken off',
  wall_off: 'centre of the wall is {distance} mm from the origin of {frame}',
  other_run: 'the other run',
  other_run_untimed: 'the other run: touches alone, no times of its moves',
  scene_aria: 'Scene of parts, probe, ways and contacts. Arrow keys turn it, plus and minus zoom. '
    + 'All values are in the touch table.',
  view: 'View',
  view_iso: 'Iso',
  view_x: 'X',
  view_y: 'Y',
  view_z: 'Z',
  view_fit: 'Fit',
  section: 'Section',
  no_webgl: 'This browser shows no 3D graphics (WebGL): a sketch of edges stands for the scene.',
  drag_to_turn: 'drag to turn, Ctrl + wheel to zoom',
  cut_drag_to_turn: 'cut open towards you, drag to turn, Ctrl + wheel to zoom',
  positions_mm: 'axis positions in mm',
  beyond_scale: 'beyond the scale',
  contact_normal: 'contact and surface normal',
  whisker_scale: 'deviations × {mag}',
  rows_left_out: '{shown} of {all} rows are printed: {rule}.',
  rule_executed: 'lines that ran',
  rule_signal: 'touches with a signal',
  touch_button: 'Touch {n}',
  view_works: 'g31 runs the program anew …',
  view_ended: 'g31 view has ended: this page stays as it is',
};

/** @type {Record<string, string>} */
let given = {};

/** @param {Record<string, string> | undefined} words of the page's language */
export function useWords(words) {
  given = words ?? {};
}

/**
 * The words of a key with {names} filled in.
 * @param {keyof typeof ENGLISH} key
 * @param {Record<string, string | number>} [values]
 */
export function word(key, values = {}) {
  const text = given[key] ?? ENGLISH[key];
  return text.replace(/\{(\w+)\}/g, (all, name) => String(values[name] ?? all));
}
