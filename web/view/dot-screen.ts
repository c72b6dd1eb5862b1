import { type BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';

/** Later than surfaces, before dots: what is worn over points is hidden by cloth alone. */
const ORDER = 1;

/** What keeps the dots of the far side from shining through between the near ones: the surface through points, unseen and set back. */
export class DotScreen {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  readonly #behind = { value: 0 };

  constructor(surface: BufferGeometry) {
    const material = new MeshBasicMaterial({ colorWrite: false, side: DoubleSide });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.behind = this.#behind;
      shader.vertexShader = `uniform float behind;\n${shader.vertexShader.replace(
        '#include <project_vertex>',
        '#include <project_vertex>\nmvPosition.z -= behind;\ngl_Position = projectionMatrix * mvPosition;',
      )}`;
    };
    this.mesh = new Mesh(surface, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = ORDER;
  }

  /** @param distance  from the surface, drawn units */
  setBehind(distance: number): void {
    this.#behind.value = distance;
  }

  dispose(): void {
    this.mesh.material.dispose();
  }
}
