// reports/view.js
// Makes every <figure class="view"> of a report a scene that can be turned: what reports/scene.c
// wrote into it is drawn by three.js. Names come from files: they are only ever set as text.
"use strict";

(function () {
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

    function canDraw() {
        const canvas = document.createElement("canvas");
        return Boolean(window.WebGLRenderingContext && window.THREE &&
                       (canvas.getContext("webgl") || canvas.getContext("experimental-webgl")));
    }

    function View(figure) {
        const source = figure.querySelector("script");
        this.data = JSON.parse(source.textContent);
        this.on = this.data.on.slice();
        this.option = this.data.choices.map((c) => c.all ? -1 : 0);
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
        this.look(0);
        this.choose();
    }

    View.prototype.setUpDrawing = function () {
        this.renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
        this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
        this.stage.appendChild(this.renderer.domElement);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(28, 1, 0.01 * this.data.size, 40 * this.data.size);
        const sun = new THREE.DirectionalLight("#ffffff", 0.75);
        sun.position.set(-0.4, 0.6, 1);
        this.camera.add(sun);
        this.scene.add(this.camera, new THREE.AmbientLight("#ffffff", 0.5));
        this.items = this.data.items.map((item) => {
            const build = builders[item.kind], object = build ? build(this.data, item) : null;
            if (object) {
                this.scene.add(object);
            }
            return {item: item, object: object};
        });
        this.items.filter((i) => i.item.labels).forEach((i) => this.setUpLabels(i));
        this.extent = this.measure();
        const again = () => this.draw();
        (window.ResizeObserver ? new ResizeObserver(again).observe(this.stage)
                               : window.addEventListener("resize", again));
    };

    // the ball around the wall, or around all there is
    View.prototype.measure = function () {
        const wall = this.items.filter((i) => i.item.kind === "wall")[0], box = new THREE.Box3();
        if (wall) {
            wall.object.children[0].geometry.computeBoundingSphere();
            return wall.object.children[0].geometry.boundingSphere;
        }
        this.items.filter((i) => i.object).forEach((i) => box.expandByObject(i.object));
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
        this.items.forEach((i) => {
            if (i.object) {
                i.object.visible = shown.indexOf(i) >= 0;
            }
        });
        this.showMotion();
        this.paintWalls(shown);
        this.tell(shown);
        this.draw();
    };

    // on the way there the moving body stands for the one that is there
    View.prototype.showMotion = function () {
        const moving = this.moving, under = moving && this.frame < moving.item.frames - 1;
        this.motion.parentNode.hidden = this.play.hidden = !moving;
        if (moving) {
            this.motionName.textContent = moving.item.name + " ";
            this.motion.max = moving.item.frames - 1;
            this.motion.value = this.frame;
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
        shown.filter((i) => i.item.kind === "key").forEach((i) => {
            const line = make("li", {}, this.key);
            make("i", {}, line).style.background = i.item.colour;
            make("span", {textContent: i.item.words}, line);
        });
        if (this.data.ramp && shown.some((i) => i.item.values)) {
            this.tellRamp(this.data.ramp);
        }
    };

    View.prototype.tellRamp = function (ramp) {
        const line = make("li", {}, this.key);
        make("span", {textContent: ramp.name + ": 0 "}, line);
        const bar = make("i", {className: "ramp"}, line);
        bar.style.background = "linear-gradient(90deg," + ramp.colours.join(",") + ")";
        make("span", {textContent: " " + Number(ramp.most.toPrecision(3)) + " or more; below 0 "},
             line);
        make("i", {}, line).style.background = ramp.below;
    };

    // --- controls

    View.prototype.setUpControls = function () {
        const bar = make("div", {className: "controls"}, this.figure);
        this.figure.insertBefore(bar, this.stage);
        this.data.choices.forEach((choice, c) => this.setUpChoice(choice, c, bar));
        const motion = field("", bar);
        this.motionName = motion.firstChild;
        this.motion = make("input", {type: "range", min: 0}, motion);
        this.motion.oninput = () => {
            this.frame = Number(this.motion.value);
            this.choose();
        };
        this.play = make("button", {type: "button", textContent: "play"}, bar);
        this.play.onclick = () => this.run();
        const layers = make("div", {className: "controls"}, this.figure);
        this.figure.insertBefore(layers, this.stage.nextSibling);
        this.data.layers.forEach((name, l) => {
            const label = make("label", {}, layers);
            const box = make("input", {type: "checkbox", checked: this.on[l]}, label);
            make("span", {textContent: " " + name}, label);
            box.onchange = () => {
                this.on[l] = box.checked;
                this.choose();
            };
        });
        looks.forEach((one, k) => {
            const button = make("button", {type: "button", textContent: one[0]}, layers);
            button.onclick = () => this.look(k);
        });
        this.key = make("ul", {className: "keys"}, this.figure);
        this.words = make("div", {className: "words"}, this.figure);
        this.words.setAttribute("aria-live", "polite");
        [this.key, this.words].forEach((e) => this.figure.insertBefore(e, layers.nextSibling));
    };

    View.prototype.setUpChoice = function (choice, c, bar) {
        const label = field(choice.name, bar), select = make("select", {}, label);
        const first = choice.all ? -1 : 0;
        if (choice.all) {
            make("option", {textContent: "all", value: -1}, select);
        }
        choice.options.forEach((name, k) => make("option", {textContent: name, value: k}, select));
        const slider = make("input", {type: "range", min: first, max: choice.options.length - 1,
                                      value: first}, label);
        slider.setAttribute("aria-label", choice.name);
        slider.hidden = choice.options.length < 5;
        const set = (from) => () => {
            this.option[c] = Number(from.value);
            select.value = slider.value = this.option[c];
            this.choose();
        };
        select.onchange = set(select);
        slider.oninput = set(slider);
    };

    // from outside to the pose, in four seconds
    View.prototype.run = function () {
        const moving = this.moving, start = performance.now();
        const step = (now) => {
            if (this.moving !== moving || !moving) {
                return;
            }
            const last = moving.item.frames - 1;
            this.frame = Math.min(last, Math.max(0, Math.floor((now - start) / 4000 * last)));
            this.choose();
            if (this.frame < last) {
                requestAnimationFrame(step);
            }
        };
        requestAnimationFrame(step);
    };

    // --- turning

    const looks = [["aslant", 0.5, 0.3], ["along y", 0, 0], ["against x", Math.PI / 2, 0],
                   ["against z", 0, Math.PI / 2 - 1e-3]];

    View.prototype.look = function (k) {
        this.azimuth = looks[k][1]; // of the eye: from -y towards x
        this.height = looks[k][2];
        this.away = 1;
        this.middle = this.extent.center.clone();
        this.draw();
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
        if (w === 0 || h === 0) {
            return;
        }
        const half = Math.tan(this.camera.fov * Math.PI / 360) * Math.min(1, w / h);
        const away = 0.95 * this.away * this.extent.radius / Math.sin(Math.atan(half));
        const flat = Math.cos(this.height);
        this.renderer.setSize(w, h, false);
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
    };

    document.querySelectorAll("figure.view").forEach((figure) => {
        if (canDraw()) {
            new View(figure);
        } else {
            figure.dataset.state = "still";
        }
    });
})();
