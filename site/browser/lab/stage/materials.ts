/** One material for each texture and each way to be drawn; a model has few of both. */
import {
  AddEquation,
  AlwaysStencilFunc,
  BackSide,
  CustomBlending,
  DoubleSide,
  EqualStencilFunc,
  FrontSide,
  GLSL3,
  type IUniform,
  KeepStencilOp,
  LessEqualDepth,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  type ShaderMaterialParameters,
  SrcAlphaFactor,
  type Texture,
} from "three";

import {
  depthFragment,
  depthVertex,
  lineFragment,
  lineVertex,
  litFragment,
  litVertex,
} from "./shaders.js";

/**
 * solid: the usual. clear: light shines through. behind: a plane from its back, through which light
 * shines too. mirror: added to its own mirror image. ghost: pale.
 */
export type Way = "solid" | "clear" | "behind" | "mirror" | "ghost";

/** How a texture lies on a shape: on the xy-plane, by the mesh's own coordinates, as a cube. */
export type Pattern = "none" | "flat" | "unwrapped" | "cube";

export type Uniforms = Record<string, IUniform>;

const defines: Readonly<Record<Pattern, Record<string, string>>> = {
  none: {},
  flat: { PICTURE: "" },
  unwrapped: { PICTURE: "", UNWRAPPED: "" },
  cube: { CUBE: "" },
};

/** Blends over what is there, and leaves the picture opaque. */
export const over: ShaderMaterialParameters = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: SrcAlphaFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
  depthWrite: false,
};

/** Behind what is at the same place. */
const setBack: ShaderMaterialParameters = {
  polygonOffset: true,
  polygonOffsetFactor: 1,
  polygonOffsetUnits: 2,
};

const ways: Readonly<Record<Way, ShaderMaterialParameters>> = {
  solid: {},
  clear: over,
  behind: { ...over, side: BackSide },
  mirror: { blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor },
  ghost: { ...over, ...setBack },
};

export class Materials {
  private readonly made = new Map<string, RawShaderMaterial>();

  /** All of them share `uniforms`. */
  constructor(private readonly uniforms: Uniforms) {}

  lit(way: Way, pattern: Pattern, map?: Texture): RawShaderMaterial {
    return this.find(`${way} ${pattern} ${map?.id ?? ""}`, () => {
      const isClear = way === "clear" || way === "behind" || way === "ghost";
      return shader(litVertex, litFragment, {
        ...ways[way],
        uniforms: { ...this.uniforms, ...(map === undefined ? {} : { map: { value: map } }) },
        defines: {
          ...defines[pattern],
          ...(isClear ? { CLEAR: "" } : {}),
          ...(way === "ghost" ? { GHOST: "" } : {}),
        },
      });
    });
  }

  /** Of a line, which light does not change. */
  line(way: Way): RawShaderMaterial {
    return this.find(`line ${way}`, () =>
      shader(lineVertex, lineFragment, { ...ways[way], side: DoubleSide, uniforms: this.uniforms }),
    );
  }

  /** Shows nothing, and hides a ghost's far sides behind its near ones. */
  screen(): RawShaderMaterial {
    return this.find("screen", () => depthMaterial(setBack));
  }

  /** Draw from now on only where the stencil is 1, or everywhere. */
  onlyInStencil(only: boolean): void {
    for (const material of this.made.values()) {
      material.stencilWrite = only;
      material.stencilRef = 1;
      material.stencilFunc = only ? EqualStencilFunc : AlwaysStencilFunc;
      material.stencilZPass = KeepStencilOp;
    }
  }

  dispose(): void {
    for (const material of this.made.values()) material.dispose();
  }

  private find(key: string, make: () => RawShaderMaterial): RawShaderMaterial {
    const known = this.made.get(key);
    if (known !== undefined) return known;
    const material = make();
    this.made.set(key, material);
    return material;
  }
}

/** Draws depths alone. */
export function depthMaterial(parameters: ShaderMaterialParameters): RawShaderMaterial {
  return shader(depthVertex, depthFragment, { colorWrite: false, ...parameters });
}

export function shader(
  vertexShader: string,
  fragmentShader: string,
  parameters: ShaderMaterialParameters,
): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    side: FrontSide,
    depthFunc: LessEqualDepth,
    ...parameters,
    vertexShader,
    fragmentShader,
  });
}
