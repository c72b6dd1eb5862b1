// The blend as a pass over the vertices on the graphics card: it writes the buffers that everything which draws the
// surface reads, so shadows, edges and whatever else follow without knowing of it.

import { GLBufferAttribute } from 'three';
import type { DrawnShape } from '../model-view';
import { BLEND_FRAGMENT, BLEND_VERTEX } from './blend-glsl';
import type { PackedFields } from './pack';
import type { BlendSurface } from './types';

const VARYINGS = ['movedPlace', 'movedNormal'];
const UNIFORMS = [
  'blendFields',
  'blendOffsets',
  'blendSets',
  'blendControls',
  'blendSingle',
  'blendQuadratic',
  'blendSteepest',
  'blendArrival',
] as const;

type Uniforms = Readonly<Record<(typeof UNIFORMS)[number], WebGLUniformLocation | null>>;

export class SurfaceBlend {
  /** What the last pass wrote. */
  readonly position: GLBufferAttribute;
  readonly normal: GLBufferAttribute;
  readonly #count: number;
  readonly #program: WebGLProgram;
  readonly #vertices: WebGLVertexArrayObject;
  /** At rest, going to, and written: places, then normals. */
  readonly #rest: WebGLBuffer[];
  #wanted: WebGLBuffer[] = [];
  readonly #written: WebGLBuffer[];
  readonly #fields: WebGLTexture;
  readonly #offsets: WebGLTexture;
  readonly #at: Uniforms;

  /** The state of `gl` is another one afterwards. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly surface: Omit<BlendSurface, 'fields' | 'gradients'>,
    packed: PackedFields,
    rest: DrawnShape,
  ) {
    this.#count = rest.places.length / 3;
    this.#program = link(gl);
    this.#at = Object.fromEntries(
      UNIFORMS.map((name) => [name, gl.getUniformLocation(this.#program, name)]),
    ) as unknown as Uniforms;
    this.#vertices = gl.createVertexArray();
    this.#rest = this.#feed(rest, 0);
    this.#written = [rest.places, rest.normals].map((array) => filled(gl, array, gl.DYNAMIC_COPY));
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const [position, normal] = this.#written.map(
      (buffer) => new GLBufferAttribute(buffer, gl.FLOAT, 3, 4, this.#count),
    );
    this.position = position!;
    this.normal = normal!;
    this.#fields = texture(gl);
    const { texels, width, height } = packed;
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      gl.RGBA16UI,
      width,
      height,
      0,
      gl.RGBA_INTEGER,
      gl.UNSIGNED_SHORT,
      texels,
    );
    this.#offsets = texture(gl);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 3, surface.sets * surface.controls);
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.useProgram(this.#program);
    gl.uniform1i(this.#at.blendFields, 0);
    gl.uniform1i(this.#at.blendOffsets, 1);
    gl.uniform1i(this.#at.blendSets, surface.sets);
    gl.uniform1i(this.#at.blendControls, surface.controls);
    gl.uniform1i(this.#at.blendSingle, Number(surface.single));
    gl.uniform1i(this.#at.blendQuadratic, Number(surface.basis === 'quadratic'));
    gl.uniform1f(this.#at.blendSteepest, packed.steepest);
    gl.useProgram(null);
  }

  /**
   * Where it is going from here, for passes that have arrived in part. The state of `gl` is another one afterwards.
   *
   * @param wanted  drawn units
   */
  goTo(wanted: DrawnShape): void {
    for (const buffer of this.#wanted) this.gl.deleteBuffer(buffer);
    this.#wanted = this.#feed(wanted, 2);
  }

  /**
   * One pass. The state of `gl` is another one afterwards.
   *
   * @param offsets  12 numbers a control, drawn units
   * @param arrival  in [0, 1]: how much of the way to what `goTo` was given
   */
  move(offsets: Float32Array, arrival = 0): void {
    const { gl } = this;
    gl.useProgram(this.#program);
    gl.uniform1f(this.#at.blendArrival, arrival);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.#offsets);
    const rows = this.surface.sets * this.surface.controls;
    // Rows of a picture as they are: three draws its own upside down.
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 3, rows, gl.RGBA, gl.FLOAT, offsets);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.#fields);
    gl.bindVertexArray(this.#vertices);
    // A buffer that is written may be bound nowhere else.
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    for (const [i, buffer] of this.#written.entries())
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, i, buffer);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, this.#count);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    for (const i of this.#written.keys()) gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, i, null);
    gl.bindVertexArray(null);
    gl.useProgram(null);
  }

  /** What the last pass wrote, drawn units; waits for the graphics card. */
  read(): DrawnShape {
    const { gl } = this;
    const [places, normals] = this.#written.map((buffer) => {
      const out = new Float32Array(3 * this.#count);
      gl.bindBuffer(gl.COPY_READ_BUFFER, buffer);
      gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, out);
      gl.bindBuffer(gl.COPY_READ_BUFFER, null);
      return out;
    });
    return { places: places!, normals: normals! };
  }

  dispose(): void {
    const { gl } = this;
    for (const buffer of [...this.#rest, ...this.#wanted, ...this.#written]) gl.deleteBuffer(buffer);
    gl.deleteTexture(this.#fields);
    gl.deleteTexture(this.#offsets);
    gl.deleteVertexArray(this.#vertices);
    gl.deleteProgram(this.#program);
  }

  /** Buffers that the vertices read from, at a location and the next. */
  #feed({ places, normals }: DrawnShape, location: number): WebGLBuffer[] {
    const { gl } = this;
    gl.bindVertexArray(this.#vertices);
    const buffers = [places, normals].map((array, i) => {
      const buffer = filled(gl, array, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location + i);
      gl.vertexAttribPointer(location + i, 3, gl.FLOAT, false, 0, 0);
      return buffer;
    });
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return buffers;
  }
}

/** A buffer, left bound. */
function filled(gl: WebGL2RenderingContext, array: Float32Array, usage: GLenum): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, array, usage);
  return buffer;
}

function texture(gl: WebGL2RenderingContext): WebGLTexture {
  const made = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, made);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
  return made;
}

/** @throws Error  what the driver says */
function link(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, BLEND_VERTEX],
    [gl.FRAGMENT_SHADER, BLEND_FRAGMENT],
  ] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    // It lives as long as the program.
    gl.deleteShader(shader);
  }
  gl.transformFeedbackVaryings(program, VARYINGS, gl.SEPARATE_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(`The blend cannot be compiled: ${gl.getProgramInfoLog(program)}`);
  return program;
}
