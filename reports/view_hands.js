// reports/view_hands.js
// Turning, moving and drawing a view; all views of the page begin here.

// --- turning

const looks = [["aslant", 0.5, 0.3], ["along y", 0, 0], ["against x", Math.PI / 2, 0],
               ["against z", 0, Math.PI / 2 - 1e-3]];

View.prototype.look = function (k) {
    this.azimuth = k === 0 && this.data.byValue ? this.aside() : looks[k][1]; // of the eye: from -y towards x
    this.height = looks[k][2];
    this.away = 1;
    this.middle = this.extent.center.clone();
    this.draw();
};

// from the side, or where most is seen of what the section has little of, such as a strip, if little of it would be
View.prototype.aside = function () {
    const first = -0.6, body = this.items.filter((i) => i.object && i.object.visible && i.body && i.body.facing).map((i) => i.body)[0];
    const rare = body ? body.facing() : [];
    const seen = (azimuth) => rare.reduce((sum, d) => sum + Math.max(0, d[0] * Math.sin(azimuth) - d[1] * Math.cos(azimuth)), 0);
    const all = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => first + k * Math.PI / 4);
    const best = all.reduce((most, one) => seen(one) > seen(most) ? one : most, first);
    return seen(best) > 2 * seen(first) ? best : first;
};

View.prototype.turn = function (right, up) {
    this.azimuth -= right;
    this.height = Math.max(-1.57, Math.min(1.57, this.height + up));
    this.draw();
};

View.prototype.zoom = function (factor) {
    this.away = Math.max(0.05, Math.min(6, this.away * factor));
    this.draw();
};

View.prototype.shift = function (right, up) {
    const scale = 2 * this.away * this.extent.radius / this.stage.clientHeight;
    const m = this.camera.matrix.elements;
    this.middle.addScaledVector(new THREE.Vector3(m[0], m[1], m[2]), -right * scale);
    this.middle.addScaledVector(new THREE.Vector3(m[4], m[5], m[6]), up * scale);
    this.draw();
};

View.prototype.setUpHands = function () {
    const fingers = new Map(), stage = this.stage;
    const spread = () => {
        const p = Array.from(fingers.values());
        return p.length < 2 ? 0 : Math.hypot(p[0].x - p[1].x, p[0].y - p[1].y);
    };
    stage.addEventListener("pointerdown", (e) => {
        fingers.set(e.pointerId, {x: e.clientX, y: e.clientY});
        stage.setPointerCapture(e.pointerId);
    });
    stage.addEventListener("pointermove", (e) => {
        const before = fingers.get(e.pointerId);
        if (!before) {
            return;
        }
        const dx = e.clientX - before.x, dy = e.clientY - before.y, wide = spread();
        fingers.set(e.pointerId, {x: e.clientX, y: e.clientY});
        if (fingers.size > 1) {
            this.shift(dx / 2, dy / 2);
            this.zoom(spread() > 0 ? wide / spread() : 1);
        } else if (e.shiftKey || e.buttons & 2) {
            this.shift(dx, dy);
        } else {
            this.turn(0.008 * dx, 0.008 * dy);
        }
    });
    ["pointerup", "pointercancel"].forEach((name) => stage.addEventListener(name, (e) => {
        fingers.delete(e.pointerId);
    }));
    stage.addEventListener("contextmenu", (e) => e.preventDefault());
    // the wheel scrolls the page until the view is being used
    stage.addEventListener("wheel", (e) => {
        if (document.activeElement === stage || e.ctrlKey) {
            e.preventDefault();
            this.zoom(Math.exp(0.0015 * e.deltaY));
        }
    }, {passive: false});
    stage.addEventListener("keydown", (e) => this.press(e));
};

View.prototype.press = function (e) {
    const keys = {
        ArrowLeft: () => this.turn(-0.1, 0), ArrowRight: () => this.turn(0.1, 0),
        ArrowUp: () => this.turn(0, -0.1), ArrowDown: () => this.turn(0, 0.1),
        "+": () => this.zoom(0.9), "=": () => this.zoom(0.9), "-": () => this.zoom(1 / 0.9),
        0: () => this.look(0),
    };
    if (keys[e.key] && !e.ctrlKey && !e.metaKey && !e.altKey) {
        e.preventDefault();
        keys[e.key]();
    }
};

// --- drawing

View.prototype.draw = function () {
    if (!this.due) {
        this.due = true;
        requestAnimationFrame(() => {
            this.due = false;
            this.drawNow();
        });
    }
};

View.prototype.drawNow = function () {
    const w = this.stage.clientWidth, h = this.stage.clientHeight;
    if (w === 0 || h === 0 || this.lost) {
        return;
    }
    const half = Math.tan(this.camera.fov * Math.PI / 360) * Math.min(1, w / h);
    const away = 0.95 * this.away * this.extent.radius / Math.sin(Math.atan(half));
    const flat = Math.cos(this.height);
    this.renderer.setSize(w, h);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(away * flat * Math.sin(this.azimuth),
                             -away * flat * Math.cos(this.azimuth), away * Math.sin(this.height));
    this.camera.position.add(this.middle);
    this.camera.lookAt(this.middle);
    this.camera.updateMatrixWorld();
    this.renderer.render(this.scene, this.camera);
    this.labels.forEach((l) => {
        const p = l.at.clone().project(this.camera);
        l.label.hidden = !l.of.object.visible || p.z > 1;
        l.label.style.transform = "translate(" + ((p.x + 1) / 2 * w + 7).toFixed(1) + "px," +
            ((1 - p.y) / 2 * h - 9).toFixed(1) + "px)";
    });
    this.figure.dataset.state = "live";
    // shown when the next frame is asked for, and not yet when the call that draws it is back
    requestAnimationFrame(() => {
        this.figure.dataset.drawn = this.figure.dataset.drawn || performance.now().toFixed(0);
    });
};

// told to whoever asks how quickly: milliseconds from asking for the page to having it, and to each view
document.documentElement.dataset.ready = performance.now().toFixed(0);

function begin(figure) {
    if (canDraw() && loadThree()) {
        new View(figure);
    } else {
        figure.dataset.state = "still";
    }
}

// the page can be read before: views are made when they come near what is seen
function beginNear(figures) {
    const margin = 600, isNear = (f) => f.getBoundingClientRect().top < window.innerHeight + margin;
    const near = new IntersectionObserver((seen) => seen.filter((s) => s.isIntersecting).forEach((s) => {
        near.unobserve(s.target);
        begin(s.target);
    }), {rootMargin: margin + "px"});
    figures.forEach((figure) => figure.dataset.state = "waiting");
    figures.forEach((figure) => isNear(figure) ? begin(figure) : near.observe(figure));
}

setTimeout(() => {
    const figures = Array.from(document.querySelectorAll("figure.view"));
    if (window.IntersectionObserver && canDraw()) {
        beginNear(figures);
    } else {
        figures.forEach(begin);
    }
}, 0);
