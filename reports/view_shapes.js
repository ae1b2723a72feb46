// reports/view_shapes.js
// What reports/scene.c packed, made into three's objects. cmake/scripts.cmake joins the view's files.

// --- unpacking

function bytesOf(text) {
    const plain = atob(text), out = new Uint8Array(plain.length);
    for (let i = 0; i < plain.length; i++) {
        out[i] = plain.charCodeAt(i);
    }
    return out;
}

function wordsOf(text) {
    const b = bytesOf(text), out = new Uint16Array(b.length / 2);
    for (let i = 0; i < out.length; i++) {
        out[i] = b[2 * i] | b[2 * i + 1] << 8;
    }
    return out;
}

// places in mm about the middle of the scene's box
function placesOf(data, text) {
    return Float32Array.from(wordsOf(text), (step) => data.size * (step / 65535 - 0.5));
}

function vector(p, i) {
    return new THREE.Vector3(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
}

// one colour per kind, three numbers each
function paintOf(kinds, colours) {
    const inks = colours.map((c) => new THREE.Color(c)), out = new Float32Array(3 * kinds.length);
    kinds.forEach((kind, i) => inks[Math.min(kind, inks.length - 1)].toArray(out, 3 * i));
    return out;
}

// --- tubes

const AROUND = 14;

// directions across the tube that turn about it as little as they can
function framesOf(p, n) {
    const frames = [];
    let across = null;
    for (let i = 0; i < n; i++) {
        const along = vector(p, Math.min(i + 1, n - 1)).sub(vector(p, Math.max(i - 1, 0)));
        if (along.lengthSq() === 0) {
            along.copy(frames.length ? frames[i - 1].along : new THREE.Vector3(0, 0, 1));
        }
        along.normalize();
        if (!across) {
            const off = Math.abs(along.z) < 0.9 ? [0, 0, 1] : [1, 0, 0];
            across = new THREE.Vector3().fromArray(off);
        }
        across.addScaledVector(along, -across.dot(along)).normalize();
        frames.push({along: along, u: across.clone(), v: along.clone().cross(across)});
    }
    return frames;
}

function fillTube(geometry, p, n, radius) {
    const place = geometry.attributes.position, normal = geometry.attributes.normal;
    framesOf(p, n).forEach((frame, i) => {
        for (let k = 0; k < AROUND; k++) {
            const angle = 2 * Math.PI * k / AROUND;
            const out = frame.u.clone().multiplyScalar(Math.cos(angle))
                .addScaledVector(frame.v, Math.sin(angle));
            const at = vector(p, i).addScaledVector(out, radius);
            normal.setXYZ(i * AROUND + k, out.x, out.y, out.z);
            place.setXYZ(i * AROUND + k, at.x, at.y, at.z);
        }
    });
    place.needsUpdate = normal.needsUpdate = true;
    geometry.computeBoundingSphere();
}

function makeTube(p, n, radius) {
    const geometry = new THREE.BufferGeometry(), index = [], room = 3 * n * AROUND;
    for (let i = 0; i + 1 < n; i++) {
        for (let k = 0; k < AROUND; k++) {
            const a = i * AROUND + k, b = i * AROUND + (k + 1) % AROUND;
            index.push(a, b, a + AROUND, b, b + AROUND, a + AROUND);
        }
    }
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(room), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(room), 3));
    geometry.setIndex(index);
    fillTube(geometry, p, n, radius);
    return geometry;
}

// 0: below; 1 .. 254: along the ramp; 255: no number
function rampColour(ramp, value) {
    if (value === 0) {
        return new THREE.Color(ramp.below);
    }
    if (value === 255) {
        return new THREE.Color(ramp.none);
    }
    const at = (value - 1) / 253 * (ramp.colours.length - 1);
    const i = Math.min(Math.floor(at), ramp.colours.length - 2);
    return new THREE.Color(ramp.colours[i]).lerp(new THREE.Color(ramp.colours[i + 1]), at - i);
}

// --- items into three's objects

const builders = {
    // the far side is drawn solid, as a bowl that is looked into; the near side like glass
    wall(data, item) {
        const geometry = new THREE.BufferGeometry(), both = new THREE.Group();
        geometry.setAttribute("position",
                              new THREE.BufferAttribute(placesOf(data, item.points), 3));
        geometry.setIndex(new THREE.BufferAttribute(wordsOf(item.triangles), 1));
        geometry.computeVertexNormals();
        const far = {color: item.colour, side: THREE.BackSide};
        const near = {color: item.colour, transparent: true, opacity: 0.14, depthWrite: false};
        both.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(far)));
        both.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(near)));
        both.children[1].renderOrder = 1;
        return both;
    },
    tube(data, item) {
        const all = placesOf(data, item.points), n = all.length / 3 / item.frames;
        const frame = (k) => all.subarray(3 * n * k, 3 * n * (k + 1));
        const geometry = makeTube(frame(item.frames - 1), n, item.radius);
        const look = {color: item.colour};
        if (item.values) {
            const paint = new Float32Array(3 * n * AROUND);
            bytesOf(item.values).forEach((value, i) => {
                const ink = rampColour(data.ramp, value);
                for (let k = 0; k < AROUND; k++) {
                    ink.toArray(paint, 3 * (i * AROUND + k));
                }
            });
            geometry.setAttribute("color", new THREE.BufferAttribute(paint, 3));
            look.color = "#ffffff";
            look.vertexColors = THREE.VertexColors;
        }
        const material = new THREE.MeshLambertMaterial(look), tube = new THREE.Group();
        const end = new THREE.Mesh(new THREE.SphereBufferGeometry(item.radius, 14, 10),
                                   new THREE.MeshLambertMaterial({color: item.colour}));
        tube.add(new THREE.Mesh(geometry, material), end);
        tube.pose = (k) => {
            fillTube(geometry, frame(k), n, item.radius);
            end.position.copy(vector(frame(k), n - 1));
        };
        tube.pose(item.frames - 1);
        return tube;
    },
    line(data, item) {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute("position",
                              new THREE.BufferAttribute(placesOf(data, item.points), 3));
        return new THREE.Line(geometry, new THREE.LineBasicMaterial({color: item.colour}));
    },
    points(data, item) {
        const p = placesOf(data, item.points), kinds = bytesOf(item.kinds);
        const ball = new THREE.SphereBufferGeometry(item.radius, 16, 12);
        // seen through whatever lies in front of them
        const looks = item.colours.map((c) => new THREE.MeshLambertMaterial(
            {color: c, depthTest: false, transparent: true}));
        const all = new THREE.Group();
        kinds.forEach((kind, i) => {
            const one = new THREE.Mesh(ball, looks[Math.min(kind, looks.length - 1)]);
            one.position.copy(vector(p, i));
            one.renderOrder = 2;
            all.add(one);
        });
        return all;
    },
};
