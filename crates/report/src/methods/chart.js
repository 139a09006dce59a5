// Draws one scene and quantity of the rows in #data; methods are switched on and off, the front is that of the ones shown.
"use strict";
const rows = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const [scene, quantity, error] = ["scene", "quantity", "error"].map(byId);
const boxes = [...document.querySelectorAll("input[data-method]")];
const colours = Object.fromEntries(boxes.map((box) => [box.dataset.method, box.dataset.colour]));
const area = { left: 70, top: 12, width: 700, height: 400 };
const smallest = 1e-7;

const element = (name, attributes, text) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
};

/** What is switched on, in the chosen scene and quantity, with its cost and error. */
function shown() {
    const on = new Set(boxes.filter((box) => box.checked).map((box) => box.dataset.method));
    return rows.filter((row) => row.scene === scene.value && row.quantity === quantity.value && on.has(row.method)
            && row.ns_per_evaluation !== null && row[error.value] !== null)
        .map((row) => ({ row, x: row.ns_per_evaluation, y: Math.max(Math.abs(row[error.value]), smallest) }));
}

/** Those that answer every point and that no other such one beats. */
function front(points) {
    const whole = points.filter(({ row }) => row.refused + row.not_finite === 0);
    const beats = (a, b) => a.x <= b.x && a.y <= b.y && (a.x < b.x || a.y < b.y);
    return whole.filter((point) => !whole.some((other) => beats(other, point))).sort((a, b) => a.x - b.x);
}

/** A logarithmic scale over whole decades. */
function scale(values, from, to) {
    const logs = values.length ? values.map(Math.log10) : [0, 1];
    const low = Math.floor(Math.min(...logs));
    const high = Math.max(Math.ceil(Math.max(...logs)), low + 1);
    const at = (value) => from + ((Math.log10(value) - low) / (high - low)) * (to - from);
    return { at, ticks: Array.from({ length: high - low + 1 }, (_, i) => low + i) };
}

function power(exponent) {
    if (exponent >= -3 && exponent <= 4) return String(Number(`1e${exponent}`));
    return `1e${exponent}`;
}

function axes(svg, x, y) {
    const { left, top, width, height } = area;
    for (const tick of x.ticks) {
        const at = x.at(10 ** tick);
        svg.append(element("path", { d: `M${at} ${top}v${height}`, class: "grid" }));
        svg.append(element("text", { x: at, y: top + height + 18, "text-anchor": "middle" }, power(tick)));
    }
    for (const tick of y.ticks) {
        const at = y.at(10 ** tick);
        svg.append(element("path", { d: `M${left} ${at}h${width}`, class: "grid" }));
        svg.append(element("text", { x: left - 6, y: at + 4, "text-anchor": "end" }, power(tick)));
    }
    svg.append(element("rect", { x: left, y: top, width, height, class: "frame" }));
    svg.append(element("text", { x: left + width / 2, y: top + height + 40, "text-anchor": "middle" }, "time of one evaluation (ns)"));
    const turned = `translate(14 ${top + height / 2}) rotate(-90)`;
    svg.append(element("text", { transform: turned, "text-anchor": "middle" }, `${error.selectedOptions[0].text} (relative)`));
}

/** Names beside their points, moved down until none lies over another. */
function place(points, x, y) {
    const taken = [];
    return [...points].sort((a, b) => y.at(a.y) - y.at(b.y)).map((point) => {
        const width = 6.6 * point.row.method.length;
        const right = x.at(point.x) + 8 + width < area.left + area.width;
        const from = right ? x.at(point.x) + 8 : x.at(point.x) - 8 - width;
        let at = y.at(point.y) + 4;
        while (taken.some((t) => Math.abs(t.at - at) < 12 && from < t.to && t.from < from + width)) at += 3;
        taken.push({ from, to: from + width, at });
        return { ...point, from, at };
    });
}

const percent = (value) => (value === null ? "" : `${(100 * value).toPrecision(3)} %`);

function draw() {
    const svg = byId("plot");
    svg.replaceChildren();
    const points = shown();
    const x = scale(points.map((point) => point.x), area.left, area.left + area.width);
    const y = scale(points.map((point) => point.y), area.top + area.height, area.top);
    axes(svg, x, y);
    const best = front(points);
    const line = best.map((point, i) => `${i ? "L" : "M"}${x.at(point.x)} ${y.at(point.y)}`).join("");
    if (line) svg.append(element("path", { d: line, class: "front" }));
    for (const { row, x: cost, y: size, from, at } of place(points, x, y)) {
        const circle = element("circle", { cx: x.at(cost), cy: y.at(size), r: 5, fill: colours[row.method] });
        circle.append(element("title", {}, `${row.method}: median ${percent(row.median)}, 95 % below ${percent(row.p95)}, ${cost.toPrecision(3)} ns`));
        svg.append(circle, element("text", { x: from, y: at }, row.method + (row.refused ? "*" : "")));
    }
    table(points, new Set(best.map((point) => point.row)));
}

function table(points, best) {
    const cells = ({ row }) => [row.method, percent(row.median), percent(row.p95), percent(row.worst), percent(row.bias),
        row.ns_per_evaluation.toPrecision(3), row.table_bytes ?? "", `${row.points - row.refused} of ${row.points}`, best.has(row) ? "yes" : ""];
    byId("rows").replaceChildren(...[...points].sort((a, b) => a.x - b.x).map((point) => {
        const line = document.createElement("tr");
        line.append(...cells(point).map((text) => Object.assign(document.createElement("td"), { textContent: text })));
        return line;
    }));
}

/** Only quantities that the scene shows can be chosen. */
function quantities() {
    const there = new Set(rows.filter((row) => row.scene === scene.value).map((row) => row.quantity));
    for (const option of quantity.options) option.disabled = !there.has(option.value);
    if (quantity.selectedOptions[0].disabled) quantity.value = [...quantity.options].find((option) => !option.disabled).value;
}

function all(on) {
    for (const box of boxes) box.checked = on;
    draw();
}

scene.addEventListener("change", () => { quantities(); draw(); });
for (const control of [quantity, error, ...boxes]) control.addEventListener("change", draw);
byId("all").addEventListener("click", () => all(true));
byId("none").addEventListener("click", () => all(false));
quantities();
draw();
