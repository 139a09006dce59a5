#!/usr/bin/env node
// Gives the emitted shaders to a browser: Tint's messages on the WGSL, and the embedded self-tests run in WebGPU
// and, as GLSL 300 es, in WebGL 2.
//
//     scripts/tint-check.mjs [FOLDER]          the folder of emitted files; default: the paper's cloud
//
// Needs Node and Chromium (CHROMIUM names it; default /usr/bin/chromium), no display and no graphics card. Exit code 0
// if Tint has no message and no self-test counts a wrong value, 1 otherwise, 2 if there is no such browser.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("..", import.meta.url));
const folder = process.argv[2] ?? join(root, "fit-configs/appendix-b/generated");
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
const read = (name) => readFileSync(join(folder, name), "utf8");

// Each flag is needed for WebGPU on the software driver.
const FLAGS = ["--headless", "--no-sandbox", "--remote-debugging-pipe", "--enable-unsafe-webgpu", "--enable-features=Vulkan",
    "--use-vulkan=swiftshader", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** A page of a fresh browser: `evaluate` runs an async function there and gives its result. */
async function open() {
    const profile = mkdtempSync(join(tmpdir(), "tint-check-"));
    const browser = spawn(chromium, [...FLAGS, `--user-data-dir=${profile}`], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    const waiting = new Map();
    let [count, rest] = [0, ""];
    // A browser that does not start, dies or hangs answers nobody.
    const giveUp = (reason) => {
        for (const answer of waiting.values()) answer({ error: { message: reason } });
    };
    browser.on("error", (error) => giveUp(error.message));
    browser.on("exit", (code) => giveUp(`it ended with ${code}`));
    browser.stdio[3].on("error", () => {});
    let watch;
    browser.stdio[4].setEncoding("utf8").on("data", (chunk) => {
        const parts = (rest + chunk).split("\0");
        rest = parts.pop();
        for (const message of parts.map((part) => JSON.parse(part))) {
            waiting.get(message.id)?.(message);
        }
    });
    const send = (method, params, sessionId) => new Promise((resolve, reject) => {
        const id = ++count;
        clearTimeout(watch);
        watch = setTimeout(() => { giveUp("no answer in 120 s"); browser.kill("SIGKILL"); }, 120_000);
        waiting.set(id, ({ result, error }) => (error ? reject(new Error(error.message)) : resolve(result)));
        browser.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
    // WebGPU wants a page of its own: an empty file is one.
    const page = join(profile, "page.html");
    writeFileSync(page, "<!doctype html>");
    const { targetId } = await send("Target.createTarget", { url: `file://${page}` });
    const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
    const { product } = await send("Browser.getVersion", {});
    const evaluate = async (task, ...args) => {
        const expression = `(${task})(...${JSON.stringify(args)})`;
        const { result, exceptionDetails } =
            await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true }, sessionId);
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    };
    // The empty page that comes before it has no WebGPU.
    const loaded = () => location.protocol === "file:" && document.readyState === "complete";
    while (!(await evaluate(loaded).catch(() => browser.exitCode !== null))) {
        await new Promise((done) => setTimeout(done, 50));
    }
    const close = () => new Promise((done) => {
        clearTimeout(watch);
        browser.on("exit", () => { rmSync(profile, { recursive: true, force: true, maxRetries: 5 }); done(); });
        if (browser.exitCode === null && browser.signalCode === null) browser.kill(); else browser.emit("exit");
    });
    return { evaluate, close, product };
}

// ---- in the page ---------------------------------------------------------------------------------------------------

async function messages(code) {
    const device = await (await navigator.gpu.requestAdapter()).requestDevice();
    device.pushErrorScope("validation");
    const { messages } = await device.createShaderModule({ code }).getCompilationInfo();
    await device.popErrorScope();
    return messages.map((m) => `${m.type} ${m.lineNum}:${m.linePos} ${m.message}`);
}

async function selfTestWebGpu(code, name, table) {
    const device = await (await navigator.gpu.requestAdapter()).requestDevice();
    const entry = `@group(0) @binding(1) var<storage, read_write> test_count: array<u32>;
        @compute @workgroup_size(1) fn main() { test_count[0] = ${name}(); }`;
    const module = device.createShaderModule({ code: `${code}\n${entry}` });
    const pipeline = await device.createComputePipelineAsync({ layout: "auto", compute: { module } });
    const [written, read] = [GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST]
        .map((usage) => device.createBuffer({ size: 4, usage }));
    const entries = [{ binding: 1, resource: written }];
    if (table) {
        const buffer = device.createBuffer({ size: 4 * table.length, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST });
        device.queue.writeBuffer(buffer, 0, new Float32Array(table));
        entries.push({ binding: 0, resource: buffer });
    }
    const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries });
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.dispatchWorkgroups(1);
    pass.end();
    encoder.copyBufferToBuffer(written, 0, read, 0, 4);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    return new Uint32Array(read.getMappedRange())[0];
}

function selfTestWebGl(code, name, table) {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const shader = (type, text) => {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
        return shader;
    };
    const program = gl.createProgram();
    const head = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    gl.attachShader(program, shader(gl.VERTEX_SHADER, `${head}void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 1.0; }`));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `${head}${code}\nout uvec4 test_count;\nvoid main() { test_count = uvec4(${name}()); }`));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32UI, 1, 1);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, gl.getParameter(gl.RENDERBUFFER_BINDING));
    gl.clearBufferuiv(gl.COLOR, 0, [4294967295, 0, 0, 0]);
    gl.useProgram(program);
    if (table) {
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.R32F, table.length / 2, 2);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, table.length / 2, 2, gl.RED, gl.FLOAT, new Float32Array(table));
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }
    gl.drawArrays(gl.POINTS, 0, 1);
    const pixel = new Uint32Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixel);
    return pixel[0];
}

// ---- the checks ----------------------------------------------------------------------------------------------------

if (!existsSync(chromium)) {
    console.error(`SKIPPED: no browser at ${chromium}`);
    process.exit(2);
}
const library = read("stratiform.wgsl");
const modules = {
    "stratiform.wgsl": library,
    "stratiform.wgsl + stratiform_self_test.wgsl": `${library}\n${read("stratiform_self_test.wgsl")}`,
    "stratiform_phase.wgsl": read("stratiform_phase.wgsl"),
};
// What stands on these, where it is emitted.
const below = ["stratiform", "stratiform_weights", "stratiform_phase"];
const pasted = (name, ending) => [...below, name].map((part) => read(`${part}.${ending}`)).join("\n");
for (const name of ["stratiform_radiance", "stratiform_shade", "stratiform_halo"]) {
    if (existsSync(join(folder, `${name}.wgsl`))) modules[`${name}.wgsl below the others`] = pasted(name, "wgsl");
}
const rows = read("phase_warped.csv").trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
const phase_table = [...rows.map((row) => row[2]), ...rows.map((row) => row[3])];
// Each library with its self-test, the table that it takes, and a constant of which a thousandth is seen.
const libraries = [
    { name: "stratiform", selfTest: "stratiform_self_test", constant: library.match(/STRATIFORM_KAPPA_S: f32 = ([0-9.]+)/)[1] },
    { name: "stratiform_phase", selfTest: "stratiform_phase_self_test", constant: "0.2145988016", table: phase_table },
];
// The radiance on top of the others, with a thousandth of a constant of the weights, or of 1 - g.
for (const [name, constant] of [["stratiform_radiance", "0.85714286"], ["stratiform_shade", /STRATIFORM_SIMILARITY: f32 = ([0-9.]+)/]]) {
    if (!existsSync(join(folder, `${name}.wgsl`))) continue;
    const number = typeof constant === "string" ? constant : read(`${name}.wgsl`).match(constant)[1];
    libraries.push({ name, selfTest: `${name}_self_test`, constant: number, table: phase_table, text: (ending) => pasted(name, ending) });
}
const slip = (code, constant) => code.replace(constant, (1.001 * constant).toFixed(9));
const page = await open().catch((error) => {
    console.error(`FAILED the browser: ${error.message}`);
    process.exit(1);
});
let failed = 0;
const check = (name, found, good) => {
    failed += good ? 0 : 1;
    console.log(`${good ? "ok    " : "FAILED"} ${name}: ${found}`);
};
try {
    console.log(page.product);
    for (const [name, code] of Object.entries(modules)) {
        const found = await page.evaluate(messages, code);
        check(`Tint, ${name}`, found.join("; ") || "no message", found.length === 0);
    }
    const broken = await page.evaluate(messages, library.replace("f32", "f23"));
    check("Tint, a planted error", broken.join("; ").split("\n")[0], broken.some((m) => m.startsWith("error")));
    for (const { name, selfTest, constant, table, text } of libraries) {
        for (const [place, run, ending] of [["WebGPU", selfTestWebGpu, "wgsl"], ["WebGL 2", selfTestWebGl, "300es.glsl"]]) {
            const code = text ? text(ending) : read(`${name}.${ending}`);
            const wrong = await page.evaluate(run, code, selfTest, table);
            check(`${selfTest} in ${place}, wrong values`, wrong, wrong === 0);
            const planted = await page.evaluate(run, slip(code, constant), selfTest, table);
            check(`${selfTest} in ${place} with a planted constant, wrong values`, planted, planted > 0);
        }
    }
} catch (error) {
    check("the browser", error.message, false);
} finally {
    await page.close();
}
process.exit(failed ? 1 : 0);
