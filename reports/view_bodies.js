// reports/view_bodies.js
// Rods that wear their section and solids that move by a factor.

// --- rods that wear their section

const CREASE = Math.cos(40 * Math.PI / 180); // where an outline is not smooth

function signedOf(text, most) {
    return Float32Array.from(wordsOf(text), (step) => most * (step / 65535 * 2 - 1));
}

// every piece of the outline has two columns of its own, so that colours end where materials do
function skinOf(item) {
    const p = signedOf(item.outline, item.most), skin = {item: item, columns: [], pieces: []};
    skin.turns = signedOf(item.turns, item.around);
    const ink = bytesOf(item.kinds);
    let from = 0;
    item.loops.forEach((n) => {
        const point = (i) => [p[2 * (from + (i + n) % n)], p[2 * (from + (i + n) % n) + 1]];
        const normal = (i) => {
            const a = point(i), b = point(i + 1), size = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
            return [(b[1] - a[1]) / size, (a[0] - b[0]) / size];
        };
        const smooth = (one, other) => {
            const even = one[0] * other[0] + one[1] * other[1] > CREASE;
            const sum = [one[0] + other[0], one[1] + other[1]], size = Math.hypot(sum[0], sum[1]);
            return even ? [sum[0] / size, sum[1] / size] : one;
        };
        for (let i = 0; i < n; i++) {
            const own = normal(i);
            skin.pieces.push({ink: ink[from + i], from: from + i, to: from + (i + 1) % n});
            skin.columns.push({at: point(i), out: smooth(own, normal(i - 1 + n))},
                              {at: point(i + 1), out: smooth(own, normal(i + 1))});
        }
        from += n;
    });
    skin.face = faceOf(skin);
    return skin;
}

// triangles over the section, each with the ink of a piece of the outline that it touches
function faceOf(skin) {
    const loops = [], flat = skin.pieces.map((piece, i) => new THREE.Vector2().fromArray(skin.columns[2 * i].at));
    let from = 0;
    skin.item.loops.forEach((n) => {
        loops.push(flat.slice(from, from + n));
        from += n;
    });
    return THREE.ShapeUtils.triangulateShape(loops[0], loops.slice(1)).map((t) => {
        const side = t.filter((a) => t.indexOf(skin.pieces[a].to) >= 0)[0];
        return {corners: t, ink: skin.pieces[side === undefined ? t[0] : side].ink};
    });
}

// x and y axis of the section and what lies along, at point k
function axesAt(axes, k) {
    const x = vector(axes, 2 * k), z = vector(axes, 2 * k + 1);
    return [x, z.clone().cross(x), z];
}

function Rod(data, item, skin) {
    this.data = data;
    this.item = item;
    this.skin = skin;
    this.points = placesOf(data, item.points);
    this.n = this.points.length / 3;
    this.axes = signedOf(item.axes, 1);
    this.strain = signedOf(item.strain, item.strained);
}

// the outline's place at point k, turned with the pattern
Rod.prototype.turned = function (p, k) {
    const c = Math.cos(this.skin.turns[k]), s = Math.sin(this.skin.turns[k]);
    return [c * p[0] - s * p[1], s * p[0] + c * p[1]];
};

// where the outside's pieces of all inks but the commonest look to, as the rod stands straight
Rod.prototype.facing = function () {
    const skin = this.skin, outside = skin.pieces.slice(0, skin.item.loops[0]), count = [], out = [];
    outside.forEach((piece) => { count[piece.ink] = (count[piece.ink] || 0) + 1; });
    const common = count.indexOf(count.reduce((most, n) => Math.max(most, n), 0));
    const rare = skin.columns.filter((c, i) => i >> 1 < outside.length && outside[i >> 1].ink !== common);
    for (let k = 0; k < this.n; k++) {
        rare.forEach((c) => out.push(this.turned(c.out, k)));
    }
    return out;
};

Rod.prototype.value = function (p, k) {
    if (this.item.strained === null) {
        return 255;
    }
    const q = this.turned(p, k), e = this.strain, r = this.skin.item.most;
    const size = Math.abs(e[3 * k] + (e[3 * k + 1] * q[0] + e[3 * k + 2] * q[1]) / r);
    return 1 + 253 * Math.min(1, size / this.data.ramp.most);
};

Rod.prototype.build = function () {
    const sides = new Corners(), ends = new Corners(), columns = this.skin.columns;
    const put = (to, p, k, out) => {
        const axes = axesAt(this.axes, k), q = this.turned(p, k);
        const at = vector(this.points, k).addScaledVector(axes[0], q[0]).addScaledVector(axes[1], q[1]);
        to.add(at, out(axes));
    };
    const across = (o, k) => (axes) => {
        const q = this.turned(o, k);
        return axes[0].clone().multiplyScalar(q[0]).addScaledVector(axes[1], q[1]);
    };
    for (let k = 0; k < this.n; k++) {
        columns.forEach((c) => put(sides, c.at, k, across(c.out, k)));
    }
    for (let k = 0; k + 1 < this.n; k++) {
        for (let i = 0; i < columns.length; i += 2) {
            const a = k * columns.length + i, b = a + columns.length;
            sides.index.push(a, a + 1, b, a + 1, b + 1, b);
        }
    }
    [[0, -1], [this.n - 1, 1]].forEach((end) => this.skin.face.forEach((t) => t.corners.forEach((corner) => {
        ends.index.push(ends.index.length);
        put(ends, columns[2 * corner].at, end[0], (axes) => axes[2].clone().multiplyScalar(end[1]));
    })));
    this.sides = sides.geometry();
    this.ends = ends.geometry();
    const look = {vertexColors: THREE.VertexColors, side: THREE.DoubleSide}, all = new THREE.Group();
    const material = new THREE.MeshLambertMaterial(look);
    all.add(new THREE.Mesh(this.sides, material), new THREE.Mesh(this.ends, material));
    return all;
};

Rod.prototype.paint = function (byValue) {
    const inks = this.skin.item.colours.map((c) => new THREE.Color(c)), skin = this.skin;
    const colour = (p, k, ink) => byValue ? rampColour(this.data.ramp, this.value(p, k)) : inks[ink];
    this.sides.setAttribute("color", colours(this.n * skin.columns.length, (i) => {
        const c = i % skin.columns.length;
        return colour(skin.columns[c].at, (i - c) / skin.columns.length, skin.pieces[c >> 1].ink);
    }));
    const faces = 3 * skin.face.length;
    this.ends.setAttribute("color", colours(2 * faces, (i) => {
        const face = skin.face[Math.floor(i % faces / 3)];
        return colour(skin.columns[2 * face.corners[i % 3]].at, i < faces ? 0 : this.n - 1, face.ink);
    }));
};

function colours(n, of) {
    const out = new Float32Array(3 * n);
    for (let i = 0; i < n; i++) {
        of(i).toArray(out, 3 * i);
    }
    return new THREE.BufferAttribute(out, 3);
}

function Corners() {
    this.place = [];
    this.normal = [];
    this.index = [];
}

Corners.prototype.add = function (at, out) {
    this.place.push(at.x, at.y, at.z);
    this.normal.push(out.x, out.y, out.z);
};

Corners.prototype.geometry = function () {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(this.place), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(this.normal), 3));
    geometry.setIndex(this.index);
    return geometry;
};

// --- solids that move by a factor

function Solid(data, rest, item) {
    this.data = data;
    this.item = item;
    this.points = placesOf(data, rest.points);
    this.moves = signedOf(item.moves, item.most);
    this.kinds = bytesOf(rest.kinds);
    this.inks = rest.colours;
    this.values = bytesOf(item.values);
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setIndex(new THREE.BufferAttribute(wordsOf(rest.triangles), 1));
}

Solid.prototype.build = function () {
    const look = {vertexColors: THREE.VertexColors, side: THREE.DoubleSide};
    return new THREE.Mesh(this.geometry, new THREE.MeshLambertMaterial(look));
};

Solid.prototype.move = function (factor) {
    const place = this.points.map((x, i) => x + factor * this.moves[i]);
    this.geometry.setAttribute("position", new THREE.BufferAttribute(place, 3));
    this.geometry.computeVertexNormals();
    this.geometry.computeBoundingSphere();
    this.geometry.computeBoundingBox();
};

Solid.prototype.paint = function (byValue) {
    const inks = this.inks.map((c) => new THREE.Color(c));
    this.geometry.setAttribute("color", colours(this.kinds.length, (i) =>
        byValue ? rampColour(this.data.ramp, this.values[i]) : inks[this.kinds[i] % inks.length]));
};
