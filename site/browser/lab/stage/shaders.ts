/**
 * OpenGL's fixed pipeline as MuJoCo uses it (render_gl3.c): corners are lit, the light between them
 * is blended, textures multiply it, and all in the numbers of the screen. Each light that casts a
 * shadow has its own share, which is dropped where the shadow map says so.
 *
 * Places and directions are the world's. A mirror image is the world turned over by `modelMatrix`:
 * light goes the same ways there, and only the eye is another.
 */
import { mostLights, mostShadows } from "./lights.js";

/** A corner of an instance: instances.ts says what that is. */
const corner = `precision highp float;
in vec4 position;
in vec4 row0, row1, row2, sizeEmission, rgba;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;

// The round ends of a capsule keep their shape, and move with its length.
vec3 stretch() {
  vec3 size = sizeEmission.xyz;
  return position.w == 0.0 ? size : vec3(size.xy, 0.5 * (size.x + size.y));
}
vec3 toWorld(vec3 local) {
  vec4 at = vec4(local, 1.0);
  return vec3(dot(row0, at), dot(row1, at), dot(row2, at));
}
vec3 worldPlace() {
  return toWorld(position.xyz * stretch() + vec3(0.0, 0.0, position.w * sizeEmission.z));
}
vec4 onScreen(vec3 place) {
  return projectionMatrix * viewMatrix * modelMatrix * vec4(place, 1.0);
}`;

const lighting = `
uniform int lightCount, plainCount;
uniform vec3 eye;
uniform float glow;
uniform vec3 lightPosition[${mostLights}], lightDirection[${mostLights}];
uniform vec3 lightAttenuation[${mostLights}], lightCone[${mostLights}];
uniform vec3 lightAmbient[${mostLights}], lightDiffuse[${mostLights}];
uniform vec3 lightSpecular[${mostLights}];

// What light i adds. Its cone: the cosine of the angle at its edge, its exponent, and 1 where its
// rays are parallel and have none.
vec3 lightAt(int i, vec3 place, vec3 normal, vec3 color, float specular, float shininess) {
  vec3 toLight = -lightDirection[i];
  float strength = 1.0;
  if (lightCone[i].z == 0.0) {
    toLight = lightPosition[i] - place;
    float d = length(toLight);
    toLight /= d;
    float along = -dot(toLight, lightDirection[i]);
    strength = along < lightCone[i].x ? 0.0 : pow(max(along, 1e-6), lightCone[i].y);
    strength /= dot(lightAttenuation[i], vec3(1.0, d, d * d));
  }
  float facing = dot(normal, toLight);
  vec3 sum = lightAmbient[i] * color;
  if (facing > 0.0) {
    float gloss = max(dot(normal, normalize(toLight + normalize(eye - place))), 1e-6);
    sum += facing * lightDiffuse[i] * color + pow(gloss, shininess) * specular * lightSpecular[i];
  }
  return strength * sum;
}`;

/** CLEAR is defined for what light shines through: it takes all light, and no shadow. */
export const litVertex = `${corner}${lighting}
in vec3 normal;
in vec4 patternSpecular;
in float shininess;
uniform float dim;
out vec3 place, plain, shaded[${mostShadows}];
out float alpha;
#ifdef PICTURE
out vec2 onPicture;
#endif
#ifdef UNWRAPPED
in vec2 uv;
#endif
#ifdef CUBE
out vec3 onCube;
#endif

void main() {
  place = worldPlace();
  vec3 facing = normal / stretch();
  facing = normalize(vec3(dot(row0.xyz, facing), dot(row1.xyz, facing), dot(row2.xyz, facing)));
  vec3 color = dim * rgba.rgb;
  float specular = patternSpecular.w;
#ifdef CLEAR
  int unshaded = lightCount;
#else
  int unshaded = plainCount;
#endif

  plain = (sizeEmission.w + glow) * color;
  for (int i = 0; i < unshaded; i++) plain += lightAt(i, place, facing, color, specular, shininess);
  plain = min(plain, 1.0);
  for (int k = 0; k < ${mostShadows}; k++) {
    int i = unshaded + k;
    shaded[k] = vec3(0.0);
    if (i < lightCount) shaded[k] = min(lightAt(i, place, facing, color, specular, shininess), 1.0);
  }
  alpha = rgba.a;

  // Textures lie on corners as they were before they were stretched.
  vec3 raw = position.xyz + vec3(0.0, 0.0, position.w);
#ifdef CUBE
  onCube = raw * patternSpecular.xyz;
#endif
#ifdef PICTURE
  onPicture = raw.xy * patternSpecular.xy - 0.5;
#endif
#ifdef UNWRAPPED
  onPicture = uv;
#endif
  gl_Position = onScreen(place);
}`;

export const litFragment = `precision highp float;
precision highp sampler2DShadow;
in vec3 place, plain, shaded[${mostShadows}];
in float alpha;
uniform vec4 mirror;
out vec4 color;
#ifdef PICTURE
in vec2 onPicture;
uniform sampler2D map;
#endif
#ifdef CUBE
in vec3 onCube;
uniform samplerCube map;
#endif

uniform sampler2DShadow shadowMap;
uniform int shadowCount;
uniform float shadowTexel;
uniform mat4 shadowMatrix[${mostShadows}];
// Of each light's part of the map: its lower left, and its side.
uniform vec3 shadowTile[${mostShadows}];

// How much of light k arrives; outside of its map it is all.
float seen(int k) {
  vec4 at = shadowMatrix[k] * vec4(place, 1.0);
  if (at.w <= 0.0) return 1.0;
  at.xyz /= at.w;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
  vec2 tile = shadowTile[k].xy;
  float side = shadowTile[k].z;
  float sum = 0.0;
  for (int tap = 0; tap < 4; tap++) {
    vec2 aside = shadowTexel * (vec2(tap & 1, tap >> 1) - 0.5);
    vec2 st = clamp(tile + side * at.xy + aside, tile + shadowTexel, tile + side - shadowTexel);
    sum += texture(shadowMap, vec3(st, clamp(at.z, 0.0, 1.0)));
  }
  return 0.25 * sum;
}

void main() {
  if (dot(mirror, vec4(place, 1.0)) < 0.0) discard;
  color = vec4(plain, alpha);
#ifndef CLEAR
  for (int k = 0; k < shadowCount; k++) {
    if (shaded[k] != vec3(0.0)) color.rgb += shaded[k] * seen(k);
  }
#endif
#ifdef PICTURE
  color *= texture(map, onPicture);
#endif
#ifdef CUBE
  color *= texture(map, onCube);
#endif
#ifdef GHOST
  color = vec4(mix(color.rgb, vec3(0.8), 0.5), 0.45 * alpha);
#endif
}`;

/** Casts a shadow, or keeps what is behind from being drawn. */
export const depthVertex = `${corner}
void main() {
  gl_Position = onScreen(worldPlace());
}`;

export const depthFragment = `precision highp float;
out vec4 color;
void main() {
  color = vec4(1.0);
}`;

/** From end to end of a strip of constant width, without light. */
export const lineVertex = `${corner}
uniform vec2 lineWidth; // in parts of half the screen
uniform float dim;
out vec4 paint;
void main() {
  vec4 here = onScreen(toWorld(vec3(0.0, 0.0, position.z * sizeEmission.z)));
  vec4 there = onScreen(toWorld(vec3(0.0, 0.0, (1.0 - position.z) * sizeEmission.z)));
  vec2 along = (there.xy / there.w - here.xy / here.w) / lineWidth;
  vec2 aside = normalize(vec2(-along.y, along.x) + 1e-9) * (2.0 * position.z - 1.0);
  here.xy -= 0.5 * position.x * aside * lineWidth * here.w;
  gl_Position = here;
  paint = vec4(dim * rgba.rgb, rgba.a);
}`;

export const lineFragment = `precision highp float;
in vec4 paint;
out vec4 color;
void main() {
  color = paint;
}`;

/** The sky turns with no one: it is looked up by the direction from the eye. */
export const skyVertex = `precision highp float;
in vec4 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 eye;
uniform float far;
out vec3 direction;
void main() {
  direction = vec3(position.x, position.z, -position.y);
  gl_Position = projectionMatrix * viewMatrix * vec4(eye + far * position.xyz, 1.0);
}`;

export const skyFragment = `precision highp float;
in vec3 direction;
uniform samplerCube map;
out vec4 color;
void main() {
  color = texture(map, direction);
}`;

/** The place's fourth number is how thick the haze is there. */
export const hazeVertex = `precision highp float;
in vec4 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform mat4 plane;
uniform float far, elevation;
out float thickness;
void main() {
  thickness = position.w;
  vec3 local = far * position.xyz;
  local.z = far * elevation * (position.z - 1.0);
  gl_Position = projectionMatrix * viewMatrix * plane * vec4(local, 1.0);
}`;

export const hazeFragment = `precision highp float;
in float thickness;
uniform vec4 haze;
out vec4 color;
void main() {
  color = vec4(haze.rgb, thickness);
}`;
