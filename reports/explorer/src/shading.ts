// Lights cells at each vertex, from the eye's upper left and from the sky. Without graphics hardware a processor draws
// every pixel, so pixels get as little work as possible.
import { BackSide, FrontSide, ShaderMaterial } from "three";

const vertexShader = `
attribute vec4 color; // as it is displayed (sRGB), opacity
varying vec4 shown;
uniform float lift; // [length] towards the eye
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vec3 n = normalize(normalMatrix * normal);
  float lamp = max(0.0, dot(n, vec3(-0.298, 0.596, 0.745))), sky = 0.5 + 0.5 * n.y;
  // Light weighs less where it is displayed: powers at every vertex would cost more than all the rest.
  shown = vec4(min(vec3(1.0), color.rgb * (0.52 + 0.12 * sky + 0.42 * lamp)), color.a);
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
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    transparent: seeThrough,
    clipping: true,
    side: FrontSide,
    uniforms: { lift: { value: 0 } },
  });
}

/** The inside of cut cells: darker, and moved towards the eye, because touching cells behind would show through. */
export function insideMaterial(): ShaderMaterial {
  const made = cellMaterial(false);
  made.side = BackSide;
  made.vertexShader = vertexShader.replace("normalMatrix * normal", "-normalMatrix * normal");
  made.fragmentShader = fragmentShader.replace("gl_FragColor = shown", "gl_FragColor = vec4(0.8 * shown.rgb, 1.0)");
  return made;
}

/** Returns what draws in this browser: graphics hardware, a processor, or nothing. */
export function whatDraws(): "hardware" | "software" | "nothing" {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return "nothing";
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|softpipe/i.test(name) ? "software" : "hardware";
}
