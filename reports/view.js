// reports/view.js
// Makes a <figure class="view"> of a report a scene that can be turned: what is shown, the controls, the words. Names come from
// files: they are only ever set as text.

// --- the page's elements

function make(name, properties, parent) {
    const e = Object.assign(document.createElement(name), properties);
    parent.appendChild(e);
    return e;
}

function field(words, parent) {
    const label = make("label", {}, parent);
    make("span", {textContent: words + " "}, label);
    return label;
}

// three.js runs from where it lies packed in the page; the page's policy knows its hash
function loadThree() {
    if (!window.THREE) {
        const packed = bytesOf(document.getElementById("three").textContent);
        make("script", {textContent: new TextDecoder().decode(inflate(packed))}, document.head);
    }
    return Boolean(window.THREE);
}

function canDraw() {
    const canvas = document.createElement("canvas");
    return Boolean(window.WebGLRenderingContext &&
                   (canvas.getContext("webgl") || canvas.getContext("experimental-webgl")));
}

function View(figure) {
    const source = figure.querySelector("script");
    this.data = JSON.parse(source.textContent);
    this.on = this.data.on.slice();
    this.option = this.data.choices.map((c) => c.first);
    this.factor = this.data.factor ? this.data.factor.first : 1;
    this.frame = 0;
    this.moving = null;
    this.labels = [];
    this.figure = figure;
    this.stage = document.createElement("div");
    this.stage.className = "stage";
    this.stage.tabIndex = 0;
    this.stage.setAttribute("role", "application");
    this.stage.setAttribute("aria-label", source.dataset.name +
        ". Arrow keys turn it, plus and minus come nearer and go away, 0 begins again.");
    figure.insertBefore(this.stage, figure.firstChild);
    this.setUpDrawing();
    this.setUpControls();
    this.setUpHands();
    this.choose();
    this.look(0);
    this.drawNow();
}

View.prototype.setUpDrawing = function () {
    this.renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.stage.appendChild(this.renderer.domElement);
    this.watchLoss(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.01 * this.data.size, 40 * this.data.size);
    const sun = new THREE.DirectionalLight("#ffffff", 0.62);
    sun.position.set(-0.4, 0.6, 1);
    this.camera.add(sun);
    this.scene.add(this.camera, new THREE.AmbientLight("#ffffff", 0.42));
    let skin = null, rest = null;
    this.items = this.data.items.map((item) => {
        const build = builders[item.kind], object = build ? build(this.data, item) : null;
        if (object) {
            this.scene.add(object);
        }
        skin = item.kind === "skin" ? skinOf(item) : skin;
        rest = item.kind === "solid" ? item : rest;
        const body = item.kind === "rod" ? new Rod(this.data, item, skin)
                   : item.kind === "moved" ? new Solid(this.data, rest, item) : null;
        return {item: item, object: object, body: body};
    });
    this.items.filter((i) => i.item.labels).forEach((i) => this.setUpLabels(i));
    this.extent = this.measure();
    // at once: what was drawn for another size must not be seen, labels beside it least of all
    const again = () => this.drawNow();
    (window.ResizeObserver ? new ResizeObserver(again).observe(this.stage)
                           : window.addEventListener("resize", again));
};

// a machine may take its graphics away, as a phone does that slept: what is left is told, and drawn when it comes back
View.prototype.watchLoss = function (canvas) {
    canvas.addEventListener("webglcontextlost", (e) => {
        e.preventDefault();
        this.lost = true;
        this.figure.dataset.state = "still";
    });
    canvas.addEventListener("webglcontextrestored", () => {
        this.lost = false;
        this.figure.dataset.state = "live";
        this.draw();
    });
};

// the ball around the wall, or around all there is
View.prototype.measure = function () {
    const wall = this.items.filter((i) => i.item.kind === "wall")[0], box = new THREE.Box3();
    if (wall) {
        wall.object.children[0].geometry.computeBoundingSphere();
        return wall.object.children[0].geometry.boundingSphere;
    }
    this.items.forEach((i) => {
        if (i.object) {
            box.expandByObject(i.object);
        }
        for (let k = 0; i.body && k < i.body.points.length / 3; k++) {
            box.expandByPoint(vector(i.body.points, k));
        }
    });
    return box.getBoundingSphere(new THREE.Sphere());
};

View.prototype.setUpLabels = function (i) {
    i.item.labels.forEach((words, k) => {
        const label = make("span", {className: "label", textContent: words}, this.stage);
        this.labels.push({label: label, of: i, at: i.object.children[k].position});
    });
};

// --- what is shown

View.prototype.isAt = function (item, all) {
    return this.option.every((chosen, c) => item.at[c] < 0 || item.at[c] === chosen ||
                                            (all && chosen < 0));
};

View.prototype.isShown = function (item) {
    return this.on[item.layer] && this.isAt(item, item.frames > 1 ? false : true);
};

function samePlace(a, b) {
    return a.layer === b.layer && a.at.every((option, c) => option === b.at[c]);
}

View.prototype.choose = function () {
    const shown = this.items.filter((i) => this.isShown(i.item));
    const moving = shown.filter((i) => i.item.frames > 1)[0] || null;
    if (moving !== this.moving) {
        this.moving = moving;
        this.frame = moving ? moving.item.frames - 1 : 0;
    }
    shown.filter((i) => i.body && !i.object).forEach((i) => {
        i.object = i.body.build();
        this.scene.add(i.object);
    });
    this.items.forEach((i) => {
        if (i.object) {
            i.object.visible = shown.indexOf(i) >= 0;
        }
    });
    this.dress(shown.filter((i) => i.body));
    this.showMotion();
    this.paintWalls(shown);
    this.tell(shown);
    this.draw();
};

View.prototype.isByValue = function () {
    return !this.data.byValue || this.option[0] === 1;
};

// bodies move and take their colours; where they are is told to whoever reads the page by a program
View.prototype.dress = function (bodies) {
    const box = new THREE.Box3(), middle = new THREE.Vector3();
    bodies.forEach((i) => {
        if (i.body.move && i.factor !== this.factor) {
            i.body.move(this.factor);
            i.factor = this.factor;
        }
        if (i.byValue !== this.isByValue()) {
            i.byValue = this.isByValue();
            i.body.paint(i.byValue);
        }
        box.expandByObject(i.object);
    });
    if (bodies.length) {
        middle.fromArray(this.data.low).addScalar(this.data.size / 2);
        const told = (v) => v.clone().add(middle).toArray().map((x) => x.toFixed(3)).join(" ");
        this.figure.dataset.low = told(box.min);
        this.figure.dataset.high = told(box.max);
        this.figure.dataset.shown = bodies.map((i) => i.item.name).join("; ");
        const last = bodies[0].body.points;
        this.figure.dataset.end = told(vector(last, last.length / 3 - 1));
    }
};

// on the way there the moving body stands for the one that is there
View.prototype.showMotion = function () {
    const moving = this.moving, under = moving && this.frame < moving.item.frames - 1;
    this.motion.parentNode.hidden = this.play.hidden = !moving;
    if (moving) {
        this.motionName.textContent = moving.item.name + " ";
        this.motion.max = moving.item.frames - 1;
        this.motion.value = this.frame;
        this.motion.setAttribute("aria-valuetext", Math.round(100 * this.frame / this.motion.max) + " % of the way");
        moving.object.visible = Boolean(under);
        moving.object.pose(this.frame);
        this.items.forEach((i) => {
            if (i !== moving && i.item.kind === "tube" && samePlace(i.item, moving.item) && under) {
                i.object.visible = false;
            }
        });
    }
};

View.prototype.paintWalls = function (shown) {
    const wall = this.items.filter((i) => i.item.kind === "wall")[0];
    const paint = shown.filter((i) => i.item.kind === "paint")[0];
    if (!wall) {
        return;
    }
    const geometry = wall.object.children[0].geometry;
    if (paint) {
        const inks = paintOf(bytesOf(paint.item.kinds), paint.item.colours);
        geometry.setAttribute("color", new THREE.BufferAttribute(inks, 3));
    }
    wall.object.children.forEach((mesh) => {
        mesh.material.vertexColors = paint ? THREE.VertexColors : THREE.NoColors;
        mesh.material.color.set(paint ? "#ffffff" : wall.item.colour);
        mesh.material.needsUpdate = true;
    });
};

View.prototype.tell = function (shown) {
    this.words.textContent = "";
    this.key.textContent = "";
    this.items.forEach((i) => {
        if (i.item.kind === "words" && this.isAt(i.item, false)) {
            make("p", {textContent: i.item.words}, this.words);
        }
    });
    const inks = shown.filter((i) => i.item.kind === "key");
    inks.filter((i) => !this.data.byValue || i.item.layer > 0 || !this.isByValue()).forEach((i) => {
        const line = make("li", {}, this.key);
        make("i", {}, line).style.background = i.item.colour;
        make("span", {textContent: i.item.words}, line);
    });
    if (this.data.ramp && this.isByValue() && shown.some((i) => i.item.values || i.item.strain)) {
        this.tellRamp(this.data.ramp);
    }
};

View.prototype.tellRamp = function (ramp) {
    const line = make("li", {}, this.key);
    make("span", {textContent: ramp.name + ": 0 "}, line);
    const bar = make("i", {className: "ramp"}, line);
    bar.style.background = "linear-gradient(90deg," + ramp.colours.join(",") + ")";
    const most = Number(ramp.most.toPrecision(3));
    make("span", {textContent: " " + most + (this.data.byValue ? "" : " or more; below 0 ")}, line);
    if (!this.data.byValue) {
        make("i", {}, line).style.background = ramp.below;
    }
};
