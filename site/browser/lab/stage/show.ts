/** All that one model needs to be drawn, and how a frame of it is drawn. */
import { Vector2, type WebGLRenderer } from "three";

import type { Scene } from "../../engine/scene.js";
import type { Simulation } from "../../engine/simulation.js";
import { Cast, findMirror, type Players } from "./cast.js";
import { Eye } from "./eye.js";
import { Gaze } from "./gaze.js";
import { geomOf } from "./geom.js";
import { Kinds } from "./kinds.js";
import { Lights } from "./lights.js";
import { Materials } from "./materials.js";
import { Mirror } from "./mirror.js";
import { ModelFields } from "./model-fields.js";
import { qualityOf } from "./quality.js";
import type { Shadows, ShadowSettings } from "./shadows.js";
import { Sky } from "./sky.js";
import { type TextureLimits, Textures } from "./textures.js";

/** The size of a picture, and how many of its pixels are one of the page's. */
export interface Frame {
  readonly width: number;
  readonly height: number;
  readonly density: number;
}

function playersOf(scene: Scene): Players {
  return { geoms: scene.geoms.map(geomOf), skins: scene.skins };
}

export class Show {
  readonly eye = new Eye();
  private readonly lights = new Lights();
  private readonly gaze = new Gaze();
  private readonly lineWidth = { value: new Vector2() };
  /** How wide a line is, in the page's pixels: MuJoCo's three of a poster, which has two for each. */
  private readonly line: number;
  private readonly shadowSettings: ShadowSettings;
  private readonly textures: Textures;
  private readonly kinds: Kinds;
  private readonly materials: Materials;
  private readonly cast: Cast;
  private readonly mirror: Mirror;
  private readonly sky: Sky | undefined;

  constructor(
    simulation: Simulation,
    private readonly shadows: Shadows,
    limits: TextureLimits,
  ) {
    const model = new ModelFields(simulation);
    this.line = 1.5 * model.number("vis.global.linewidth");
    this.shadowSettings = {
      clip: model.number("stat.extent") * model.number("vis.map.shadowclip"),
      scale: model.number("vis.map.shadowscale"),
      size: model.number("vis.quality.shadowsize"),
    };
    const quality = qualityOf(model);
    const { lights, gaze, lineWidth } = this;
    const uniforms = { ...lights.uniforms, ...shadows.uniforms, ...gaze.uniforms, lineWidth };
    this.textures = new Textures(model, limits);
    this.kinds = new Kinds(model, this.textures, quality);
    this.materials = new Materials(uniforms);
    this.cast = new Cast(this.kinds, this.materials, model.array("geom_rbound").slice());
    this.mirror = new Mirror(this.cast, this.kinds, this.materials, gaze);
    if (this.textures.sky === undefined) return;
    this.sky = new Sky(model, this.textures.sky, gaze.uniforms, quality);
    this.cast.addSky(this.sky.meshes);
  }

  /** Draws `scene`, and the bodies of `ghost` as its shadow, to the lower left of the canvas. */
  draw(renderer: WebGLRenderer, frame: Frame, scene: Scene, ghost: Scene | undefined): void {
    const { eye, lights, cast, gaze } = this;
    const { plainCount, lightCount } = lights.uniforms;
    const players = playersOf(scene);
    const { geoms } = players;
    eye.look(scene.eyes, frame.width / frame.height);
    lights.read(scene.lights, eye, this.shadowSettings.size > 0 ? Infinity : 0);
    this.lineWidth.value.set(2 / frame.width, 2 / frame.height);
    this.lineWidth.value.multiplyScalar(this.line * frame.density);
    const reflecting = findMirror(geoms, eye);
    cast.assemble(players, eye, reflecting, ghost && playersOf(ghost));
    this.sky?.place(geoms, eye);

    gaze.straight(eye);
    this.shadows.draw(renderer, cast.scene, lights.casting, eye, this.shadowSettings);
    renderer.setViewport(0, 0, frame.width, frame.height);
    renderer.clear();
    if (reflecting !== undefined) {
      plainCount.value = lightCount.value;
      this.mirror.draw(renderer, reflecting, eye);
      plainCount.value -= lights.casting.length;
    }
    renderer.render(cast.scene, eye.camera);
  }

  dispose(): void {
    this.sky?.dispose();
    this.mirror.dispose();
    this.cast.dispose();
    this.materials.dispose();
    this.textures.dispose();
  }
}
