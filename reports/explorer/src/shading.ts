// How cells are lit: from the eye's upper left and from the sky, at each vertex. Without graphics hardware a processor draws every
// pixel, so as little as can be is left to be done there.
import { BackSide, FrontSide, ShaderMaterial } from "three";

const vertexShader = `
attribute vec4 color; // linear light, opacity
varying vec4 shown;
uniform float lift; // [length] towards the eye
#include <clipping_planes_pars_vertex>
vec3 displayed(vec3 light) { // sRGB [IEC 61966-2-1]
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vec3 n = normalize(normalMatrix * normal);
  float lamp = max(0.0, dot(n, normalize(vec3(-0.4, 0.8, 1.0)))), sky = 0.5 + 0.5 * n.y;
  shown = vec4(displayed(min(vec3(1.0), color.rgb * (0.3 + 0.2 * sky + 0.65 * lamp))), color.a);
  #include <clipping_planes_vertex>
  mvPosition.z += lift;
  gl_Position = projectionMatrix * mvPosition;
}`;

const fragmentShader = `
varying vec4 shown;
#include <clipping_planes_pars_fragment>
void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = shown;
}`;

export function cellMaterial(seeThrough: boolean): ShaderMaterial {
  return new ShaderMaterial({ vertexShader, fragmentShader, transparent: seeThrough, clipping: true, side: FrontSide, uniforms: { lift: { value: 0 } } });
}

/** The inside of cells that are cut open: darker, and nearer to the eye than it is, for the cells behind touch it and would show through. */
export function insideMaterial(): ShaderMaterial {
  const made = cellMaterial(false);
  made.side = BackSide;
  made.vertexShader = vertexShader.replace("normalMatrix * normal", "-normalMatrix * normal");
  made.fragmentShader = fragmentShader.replace("gl_FragColor = shown", "gl_FragColor = vec4(0.8 * shown.rgb, 1.0)");
  return made;
}

/** Whether a processor draws, and no graphics hardware. */
export function drawsInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|softpipe/i.test(name);
}
