// The surface of solids: tops light, floors darker the deeper they lie, walls darker still, cut faces hatched.
import { Color, DoubleSide, GLSL3, ShaderMaterial, Vector2, Vector3 } from 'three';

const VERTEX = `
out vec3 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xyz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

// A back face is seen through the cut alone: what shows there is the cut face in front of it, hatched.  Its depth stays
// that of the back face, so that nearer walls hide it, and a little less, so that edges on it do not shine through.
const FRAGMENT = `
in vec3 place;
out vec4 colour;
uniform vec3 topInk, floorInk, wallInk, sideInk, cutInk, hatchInk;
uniform vec3 apex, eye;
uniform vec2 first, second;
uniform vec2 heights;
uniform float isOpen, pixel, bias;

vec3 surface(vec3 normal) {
  float level = clamp((place.z - heights.x) / max(heights.y - heights.x, 1e-6), 0.0, 1.0);
  if (normal.z > 0.7) return mix(floorInk, topInk, level * level);
  vec2 across = vec2(-eye.y, eye.x);
  float side = 0.5 + 0.5 * dot(normal.xy, normalize(across + 1e-6));
  return mix(wallInk, sideInk, side);
}

void main() {
  float d1 = dot(place.xy - apex.xy, first);
  float d2 = dot(place.xy - apex.xy, second);
  if (isOpen > 0.5 && d1 > 0.0 && d2 > 0.0) discard;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, eye) < 0.0) normal = -normal;
  colour = vec4(surface(normal), 1.0);
  gl_FragDepth = gl_FragCoord.z + bias;
  if (isOpen < 0.5 || gl_FrontFacing) return;
  float s1 = max(-d1, 0.0) / max(dot(first, eye.xy), 1e-4);
  float s2 = max(-d2, 0.0) / max(dot(second, eye.xy), 1e-4);
  vec3 cut = place + eye * max(s1, s2);
  vec2 m = s1 > s2 ? first : second;
  float along = dot(cut.xy, vec2(-m.y, m.x)) * (s1 > s2 ? 1.0 : -1.0);
  float line = abs(fract((along + cut.z) / (pixel * 8.0)) - 0.5);
  colour.rgb = mix(hatchInk, cutInk, smoothstep(0.06, 0.16, line));
  gl_FragDepth = gl_FragCoord.z - 0.05 * bias;
}`;

const BALL_VERTEX = `
out vec3 facing;
void main() {
  facing = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// A disc with a rim of constant width on the screen; a little shade says that it is a ball.
const BALL_FRAGMENT = `
in vec3 facing;
out vec4 colour;
uniform vec3 rimInk, fillInk, eye;
uniform float radius;
void main() {
  float off = sqrt(max(0.0, 1.0 - pow(dot(normalize(facing), eye), 2.0))) * radius;
  vec3 fill = mix(fillInk, rimInk, 0.22 * smoothstep(-0.2, 1.0, -normalize(facing).z));
  colour = vec4(mix(fill, rimInk, smoothstep(radius - 2.6, radius - 1.6, off)), 1.0);
}`;

/** A colour of the page as its own red, green and blue. @param {string} css */
function plain(css) {
  const colour = new Color(css).convertLinearToSRGB();
  return new Vector3(colour.r, colour.g, colour.b);
}

/** @param {[number, number]} heights z of bottom and top */
export function solidMaterial(heights) {
  const zero = () => new Vector3();
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    uniforms: {
      topInk: { value: zero() }, floorInk: { value: zero() }, wallInk: { value: zero() }, sideInk: { value: zero() },
      cutInk: { value: zero() }, hatchInk: { value: zero() }, apex: { value: zero() }, eye: { value: zero() },
      first: { value: new Vector2(1, 0) }, second: { value: new Vector2(1, 0) }, heights: { value: new Vector2(...heights) },
      isOpen: { value: 0 }, pixel: { value: 1 }, bias: { value: 0 },
    },
  });
}

export function ballMaterial() {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: BALL_VERTEX,
    fragmentShader: BALL_FRAGMENT,
    uniforms: {
      rimInk: { value: new Vector3() }, fillInk: { value: new Vector3() }, eye: { value: new Vector3() }, radius: { value: 1 },
    },
  });
}

/** @param {ShaderMaterial} material @param {(name: string) => string} ink css of a role of colour */
export function paintSolid(material, ink) {
  const { uniforms } = material;
  const roles = { topInk: 'mat', floorInk: 'mat3', wallInk: 'mat3', sideInk: 'mat2', cutInk: 'mat4', hatchInk: 'ink3' };
  for (const [uniform, role] of Object.entries(roles)) uniforms[uniform].value = plain(ink(role));
}

/** @param {ShaderMaterial} material @param {(name: string) => string} ink @param {boolean} broken */
export function paintBall(material, ink, broken) {
  material.uniforms.rimInk.value = plain(ink(broken ? 'bad' : 'skip'));
  material.uniforms.fillInk.value = plain(ink(broken ? 'bad2' : 'paper'));
}
