// reports/view_controls.js
// What one chooses in a view: sliders, lists, layers, the way into a pose.

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
    this.setUpFactor(bar);
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

View.prototype.setUpFactor = function (bar) {
    const f = this.data.factor;
    if (!f) {
        return;
    }
    const label = field(f.name, bar), part = f.most / 40;
    const slider = make("input", {type: "range", min: 0, max: 40, value: Math.round(f.first / part)},
                        label);
    const told = make("output", {}, label), own = make("button", {type: "button",
                                                                  textContent: "true size"}, bar);
    const tell = (factor) => {
        told.textContent = " × " + Number(factor.toPrecision(3));
        slider.setAttribute("aria-valuetext", "times " + Number(factor.toPrecision(3)));
    };
    const set = (factor) => {
        this.factor = factor;
        tell(factor);
        this.choose();
    };
    tell(f.first);
    slider.oninput = () => set(part * Number(slider.value));
    own.onclick = () => {
        slider.value = Math.round(1 / part);
        set(1);
    };
};

View.prototype.setUpChoice = function (choice, c, bar) {
    const label = field(choice.name, bar), select = make("select", {}, label);
    const lowest = choice.all ? -1 : 0, here = this.option[c];
    if (choice.all) {
        make("option", {textContent: "all", value: -1}, select);
    }
    choice.options.forEach((name, k) => make("option", {textContent: name, value: k}, select));
    const slider = make("input", {type: "range", min: lowest,
                                  max: choice.options.length - 1, value: here}, label);
    select.value = here;
    slider.setAttribute("aria-label", choice.name);
    slider.hidden = choice.options.length < 3;
    const tell = () => slider.setAttribute("aria-valuetext", select.selectedOptions[0].textContent);
    const set = (from) => () => {
        this.option[c] = Number(from.value);
        select.value = slider.value = this.option[c];
        tell();
        this.choose();
    };
    tell();
    select.onchange = set(select);
    slider.oninput = set(slider);
};

// from outside to the pose, in four seconds; at once for who wants no motion
View.prototype.run = function () {
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    const moving = this.moving, start = performance.now() - (still ? 4000 : 0);
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

