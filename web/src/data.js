// The flight's columns, decoded from the page. `reporting.page` writes them: 16-bit numbers over each column's range,
// as differences from one to the next, all low bytes before all high bytes, deflated.
import { unzlibSync } from "fflate";

const MISSING = 65535;

export function decode(told, base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const bytes = unzlibSync(packed);
  const half = bytes.length / 2;
  const rows = told.rows;
  const columns = {};
  told.columns.forEach(({ name, low, step }, i) => {
    const values = new Float64Array(rows);
    let word = 0;
    for (let k = 0; k < rows; k++) {
      const at = i * rows + k;
      word = (word + bytes[at] + 256 * bytes[half + at]) & 0xffff;
      values[k] = word === MISSING ? NaN : low + step * word;
    }
    columns[name] = values;
  });
  return columns;
}

// A number with so many decimals, and no sign before a zero.
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text;
}

export function rowAt(time, t) {
  let low = 0;
  let high = time.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (time[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

// The last row in which a flight still is: its columns may go on without values.
export function lastOf(values) {
  let k = values.length - 1;
  while (k > 0 && !Number.isFinite(values[k])) k -= 1;
  return k;
}
