/** MuJoCo's lights as the shaders take them: those without a shadow first. */
import type { Struct } from "../../engine/struct-layout.js";
import type { Eye } from "./eye.js";

/** As many as OpenGL's fixed pipeline has, and so MuJoCo's renderer. */
export const mostLights = 8;
/** Of them; what casts more lights without a shadow. */
export const mostShadows = 4;

/** Light where a model has no light at all, not even a headlight. */
const ambient = 0.3;

type Numbers = Struct["numbers"];

export class Lights {
  readonly uniforms = {
    lightCount: { value: 0 },
    plainCount: { value: 0 },
    glow: { value: 0 },
    lightPosition: triples(),
    lightDirection: triples(),
    lightAttenuation: triples(),
    lightCone: triples(),
    lightAmbient: triples(),
    lightDiffuse: triples(),
    lightSpecular: triples(),
  };
  /** Those that cast a shadow, in the shaders' order. */
  casting: readonly Struct[] = [];

  /** At most `shadows` of them may cast one. */
  read(lights: readonly Struct[], eye: Eye, shadows: number): void {
    const all = lights.slice(0, mostLights);
    const casting = all.filter(({ numbers }) => numbers["castshadow"]![0] !== 0);
    this.casting = casting.slice(0, Math.min(shadows, mostShadows));
    const plain = all.filter((light) => !this.casting.includes(light));
    [...plain, ...this.casting].forEach(({ numbers }, i) => this.set(i, numbers, eye));
    const { lightCount, plainCount, glow } = this.uniforms;
    lightCount.value = all.length;
    plainCount.value = plain.length;
    glow.value = all.length > 0 ? 0 : ambient;
  }

  private set(i: number, light: Numbers, { position, forward }: Eye): void {
    const { uniforms } = this;
    const at = 3 * i;
    const isDirectional = light["directional"]![0] !== 0;
    const cutoff = light["cutoff"]![0]!;
    // 180 degrees are no cone at all.
    const edge = cutoff >= 180 ? -2 : Math.cos((cutoff * Math.PI) / 180);
    uniforms.lightCone.value.set([edge, light["exponent"]![0]!, Number(isDirectional)], at);
    uniforms.lightAttenuation.value.set(light["attenuation"]!, at);
    uniforms.lightAmbient.value.set(light["ambient"]!, at);
    uniforms.lightDiffuse.value.set(light["diffuse"]!, at);
    uniforms.lightSpecular.value.set(light["specular"]!, at);
    const isHeadlight = light["headlight"]![0] !== 0;
    uniforms.lightPosition.value.set(isHeadlight ? position.toArray() : light["pos"]!, at);
    const direction = isHeadlight ? forward.toArray() : light["dir"]!;
    const length = Math.hypot(...direction);
    uniforms.lightDirection.value.set(
      Array.from(direction, (x) => x / length),
      at,
    );
  }
}

function triples() {
  return { value: new Float32Array(3 * mostLights) };
}
