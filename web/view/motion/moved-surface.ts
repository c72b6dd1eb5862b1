// A motion as a pass over the vertices on the graphics card: it writes the buffers that everything which draws the
// surface reads, so shadows, edges and whatever else follow without knowing of it.

import { GLBufferAttribute } from 'three';
import type { DrawnShape } from '../model-view';
import { MOTION_FRAGMENT, motionVertex } from './motion-glsl';
import type { MotionTable, MotionTexture, PackedMotion, VertexInput } from './types';

const VARYINGS = ['movedPlace', 'movedNormal'];
/** Of places and normals; those on the way to them are the next two. */
const REST = 0;
const WANTED = 2;

export class MovedSurface {
  /** What the last pass wrote. */
  readonly position: GLBufferAttribute;
  readonly normal: GLBufferAttribute;
  readonly #count: number;
  readonly #program: WebGLProgram;
  readonly #vertices: WebGLVertexArrayObject;
  /** What vertices read: places, then normals, at rest, then what the motion has of its own. */
  readonly #read: WebGLBuffer[];
  /** Places, then normals, going to, and written. */
  #wanted: WebGLBuffer[] = [];
  readonly #written: WebGLBuffer[];
  readonly #textures: WebGLTexture[];
  readonly #table: WebGLTexture;
  readonly #arrival: WebGLUniformLocation | null;

  /** The state of `gl` is another one afterwards. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly motion: PackedMotion,
    rest: DrawnShape,
  ) {
    this.#count = rest.places.length / 3;
    this.#program = link(gl, motionVertex(motion.glsl));
    this.#arrival = gl.getUniformLocation(this.#program, 'motionArrival');
    this.#vertices = gl.createVertexArray();
    this.#read = [...this.#feed(rest, REST), ...motion.inputs.map((input) => this.#input(input))];
    this.#written = [rest.places, rest.normals].map((array) => filled(gl, array, gl.DYNAMIC_COPY));
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const [position, normal] = this.#written.map(
      (buffer) => new GLBufferAttribute(buffer, gl.FLOAT, 3, 4, this.#count),
    );
    this.position = position!;
    this.normal = normal!;
    this.#textures = motion.textures.map((each) => texture(gl, each));
    const { name, width, height } = motion.table;
    this.#table = texture(gl, { width, height, texels: null });
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.useProgram(this.#program);
    for (const [unit, sampler] of [name, ...motion.textures.map((each) => each.name)].entries())
      gl.uniform1i(gl.getUniformLocation(this.#program, sampler), unit);
    gl.useProgram(null);
  }

  /**
   * Where it is going from here, for passes that have arrived in part. The state of `gl` is another one afterwards.
   *
   * @param wanted  drawn units
   */
  goTo(wanted: DrawnShape): void {
    for (const buffer of this.#wanted) this.gl.deleteBuffer(buffer);
    this.#wanted = this.#feed(wanted, WANTED);
  }

  /**
   * One pass. The state of `gl` is another one afterwards.
   *
   * @param arrival  in [0, 1]: how much of the way to what `goTo` was given
   */
  move(table: MotionTable, arrival = 0): void {
    const { gl, motion } = this;
    const { width, height } = motion.table;
    gl.useProgram(this.#program);
    gl.uniform1f(this.#arrival, arrival);
    for (const [i, each] of this.#textures.entries()) {
      gl.activeTexture(gl.TEXTURE1 + i);
      gl.bindTexture(gl.TEXTURE_2D, each);
    }
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.#table);
    plainRows(gl);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, motion.tableOf(table));
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
    for (const buffer of [...this.#read, ...this.#wanted, ...this.#written]) gl.deleteBuffer(buffer);
    for (const each of [...this.#textures, this.#table]) gl.deleteTexture(each);
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

  #input({ name, values }: VertexInput): WebGLBuffer {
    const { gl } = this;
    const location = gl.getAttribLocation(this.#program, name);
    gl.bindVertexArray(this.#vertices);
    const buffer = filled(gl, values, gl.STATIC_DRAW);
    if (location >= 0) {
      gl.enableVertexAttribArray(location);
      if (values instanceof Float32Array) gl.vertexAttribPointer(location, 4, gl.FLOAT, false, 0, 0);
      else gl.vertexAttribIPointer(location, 4, gl.UNSIGNED_SHORT, 0, 0);
    }
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return buffer;
  }
}

/** A buffer, left bound. */
function filled(gl: WebGL2RenderingContext, array: Float32Array | Uint16Array, usage: GLenum): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, array, usage);
  return buffer;
}

/** Texels as they are, four numbers each. */
function texture(
  gl: WebGL2RenderingContext,
  {
    width,
    height,
    texels,
  }: Pick<MotionTexture, 'width' | 'height'> & { texels: MotionTexture['texels'] | null },
): WebGLTexture {
  const made = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, made);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  plainRows(gl);
  const whole = texels instanceof Uint16Array;
  gl.texStorage2D(gl.TEXTURE_2D, 1, whole ? gl.RGBA16UI : gl.RGBA32F, width, height);
  const [format, type] = whole ? [gl.RGBA_INTEGER, gl.UNSIGNED_SHORT] : [gl.RGBA, gl.FLOAT];
  if (texels) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, texels);
  return made;
}

/** Rows of a picture as they are: three draws its own upside down. */
function plainRows(gl: WebGL2RenderingContext): void {
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
}

/** @throws Error  what the driver says */
function link(gl: WebGL2RenderingContext, vertex: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, MOTION_FRAGMENT],
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
    throw new Error(`The motion cannot be compiled: ${gl.getProgramInfoLog(program)}`);
  return program;
}
