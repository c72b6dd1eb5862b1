import { ByteWriter } from './byte-writer';
import type { GltfJson } from './gltf-schema';

const BASE64 = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';

/** The file of a document whose first buffer is `binary`: a .glb container, or JSON with the buffer inside. */
export function packGltf(json: GltfJson, binary: Uint8Array, format: 'glb' | 'gltf'): Uint8Array {
  return format === 'glb' ? packGlb(json, binary) : packJson(json, binary);
}

function packGlb(json: GltfJson, binary: Uint8Array): Uint8Array {
  const text = new ByteWriter();
  const [, ...others] = json.buffers ?? [];
  text.text(JSON.stringify({ ...json, buffers: [{ byteLength: binary.length }, ...others] }));
  text.align(4, 32);
  const padding = (4 - (binary.length % 4)) % 4;
  const out = new ByteWriter(28 + text.length + binary.length + padding);
  out.text('glTF');
  out.u32(2);
  out.u32(28 + text.length + binary.length + padding);
  out.u32(text.length);
  out.text('JSON');
  out.raw(text.finish());
  out.u32(binary.length + padding);
  out.text('BIN\0');
  out.raw(binary);
  out.align(4);
  return out.finish();
}

function packJson(json: GltfJson, binary: Uint8Array): Uint8Array {
  // The buffer is far larger than the rest: its letters are written one by one where this word stands.
  const place = 'data:application/octet-stream;base64,';
  const [, ...others] = json.buffers ?? [];
  const text = JSON.stringify(
    { ...json, buffers: [{ byteLength: binary.length, uri: place }, ...others] },
    null,
    1,
  );
  const at = text.indexOf(`"${place}"`) + 1 + place.length;
  const out = new ByteWriter(text.length + 1.4 * binary.length);
  out.text(text.slice(0, at));
  for (let i = 0; i < binary.length; i += 3) {
    const left = binary.length - i;
    const group = (binary[i]! << 16) | ((binary[i + 1] ?? 0) << 8) | (binary[i + 2] ?? 0);
    for (let k = 0; k < 4; k++) out.byte(k <= left ? BASE64.charCodeAt((group >> (18 - 6 * k)) & 63) : 61);
  }
  out.text(text.slice(at));
  return out.finish();
}
