// reports/view_inflate.js
// Unpacks gzip (RFC 1951 within 1952), in which three.js stands in the page: a fifth of its size, in every browser.

const LENGTH_FROM = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227,
                     258];
const LENGTH_BITS = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const CODE_ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

// how many codes there are of each length, and the symbols in order of their codes
function codesOf(lengths) {
    const count = new Uint16Array(16), next = new Uint16Array(17), symbol = new Uint16Array(lengths.length);
    lengths.forEach((n) => count[n]++);
    count[0] = 0;
    for (let n = 1; n < 16; n++) {
        next[n + 1] = next[n] + count[n];
    }
    lengths.forEach((n, i) => {
        if (n) {
            symbol[next[n]++] = i;
        }
    });
    return {count: count, symbol: symbol};
}

// packed: a gzip file without name or comment; its last four bytes are the size of what is in it
function inflate(packed) {
    const end = packed.length - 4;
    const out = new Uint8Array(packed[end] | packed[end + 1] << 8 | packed[end + 2] << 16);
    let at = 10, bit = 0, held = 0, to = 0;

    function bits(n) {
        for (; held < n; held += 8) {
            bit |= packed[at++] << held;
        }
        const value = bit & (1 << n) - 1;
        bit >>>= n;
        held -= n;
        return value;
    }

    function decode(codes) {
        let code = 0, first = 0, index = 0;
        for (let n = 1; n < 16; n++) {
            code |= bits(1);
            if (code - first < codes.count[n]) {
                return codes.symbol[index + code - first];
            }
            index += codes.count[n];
            first = first + codes.count[n] << 1;
            code <<= 1;
        }
        throw new Error("damaged");
    }

    function own() {
        const literals = bits(5) + 257, distances = bits(5) + 1, lengths = new Array(19).fill(0), all = [];
        for (let i = bits(4) + 4, k = 0; k < i; k++) {
            lengths[CODE_ORDER[k]] = bits(3);
        }
        const codes = codesOf(lengths);
        while (all.length < literals + distances) {
            const symbol = decode(codes);
            const times = symbol < 16 ? 1 : symbol === 16 ? 3 + bits(2) : symbol === 17 ? 3 + bits(3) : 11 + bits(7);
            const what = symbol < 16 ? symbol : symbol === 16 ? all[all.length - 1] : 0;
            for (let k = 0; k < times; k++) {
                all.push(what);
            }
        }
        return [codesOf(all.slice(0, literals)), codesOf(all.slice(literals))];
    }

    function fixed() {
        const length = (i) => i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
        return [codesOf(Array.from({length: 288}, (_, i) => length(i))), codesOf(new Array(30).fill(5))];
    }

    function copy(codes, symbol) {
        const size = LENGTH_FROM[symbol - 257] + bits(LENGTH_BITS[symbol - 257]), far = decode(codes), more = Math.max(0, (far >> 1) - 1);
        const back = far < 4 ? far + 1 : (2 + (far & 1) << more) + 1 + bits(more);
        for (const last = to + size; to < last; to++) {
            out[to] = out[to - back];
        }
    }

    function stored() {
        bit = held = 0;
        const n = packed[at] | packed[at + 1] << 8;
        out.set(packed.subarray(at + 4, at + 4 + n), to);
        at += 4 + n;
        to += n;
    }

    for (let last = 0; !last;) {
        last = bits(1);
        const kind = bits(2);
        if (kind === 0) {
            stored();
            continue;
        }
        const codes = kind === 1 ? fixed() : own();
        for (let symbol = decode(codes[0]); symbol !== 256; symbol = decode(codes[0])) {
            if (symbol < 256) {
                out[to++] = symbol;
            } else {
                copy(codes[1], symbol);
            }
        }
    }
    return out;
}
