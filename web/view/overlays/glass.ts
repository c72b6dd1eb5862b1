import { Color, DoubleSide, ShaderMaterial } from 'three';

const COLOUR = '#4f8cff';

/** Glass: clearest where one looks straight through it. */
export function glass(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    toneMapped: false,
    uniforms: { colour: { value: new Color(COLOUR).convertLinearToSRGB() } },
    vertexShader: /* glsl */ `
      varying vec3 vNormal_;
      varying vec3 vEye;
      void main() {
        vec4 seen = modelViewMatrix * vec4(position, 1.0);
        vNormal_ = normalMatrix * normal;
        vEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      varying vec3 vNormal_;
      varying vec3 vEye;
      void main() {
        float facing = abs(dot(normalize(vNormal_), normalize(vEye)));
        gl_FragColor = vec4(mix(vec3(1.0), colour, 0.75), mix(0.5, 0.16, facing));
      }`,
  });
}
