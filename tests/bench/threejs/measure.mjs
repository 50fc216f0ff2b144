// Times the lab and three.js on the same scenes and the same driver, in turns: from process to pixels, and steady frames.
// SPDX-License-Identifier: MIT
//
//   node measure.mjs BIN_DIRECTORY OUT_DIRECTORY [--quick]      writes OUT_DIRECTORY/threejs.json and .csv
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [bin, out, amount] = process.argv.slice(2);
const rounds = amount === '--quick' ? 3 : 9, frames = amount === '--quick' ? 10 : 30;
const folder = join(out, 'threejs');
const template = readFileSync(join(dirname(fileURLToPath(import.meta.url)), 'page.html'), 'utf8');
const versions = { r146: 'three-r146', newest: 'three-newest' };

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const lab = (program, ...options) => execFileSync(join(bin, program), options, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const timed = (work) => {
    const start = process.hrtime.bigint();
    work();
    return Number(process.hrtime.bigint() - start) / 1e6;
};
const writeWhole = (file, text) => {
    writeFileSync(file + '.tmp', text);
    renameSync(file + '.tmp', file);
};

// Chromium's way to Mesa's EGL; without it there is only SwiftShader, another driver.
function inChromium(page, ...options) {
    const profile = mkdtempSync(join(tmpdir(), 'bench-chromium-'));
    try {
        return execFileSync('chromium', ['--headless', '--no-sandbox', '--disable-gpu-sandbox', '--disable-quic', '--no-first-run',
            '--disable-background-networking', '--disable-component-update', '--disable-sync', '--ignore-gpu-blocklist',
            '--use-gl=angle', '--use-angle=gl-egl', '--allow-file-access-from-files', '--window-size=512,512',
            `--user-data-dir=${profile}`, ...options, `file://${page}`], { encoding: 'utf8', timeout: 120000, stdio: ['ignore', 'pipe', 'ignore'] });
    } finally {
        rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
    }
}

function draw(page) {
    const found = /<pre>RESULT(.*?)END<\/pre>/s.exec(inChromium(page, '--dump-dom'));
    if (!found) throw new Error(`Chromium drew nothing of ${page}: open it by hand with the options of measure.mjs to see why`);
    const result = JSON.parse(found[1].replaceAll('&amp;', '&'));
    if (result.bright < 1000) throw new Error(`three.js's picture of ${page} is black`);
    return result;
}

// The lecture's scene as lesson 04 has it, and the same under 64 point lights instead.
function scenes() {
    const file = join(folder, 'lecture.json');
    lab('lesson_04_ambient', '--dump-scene', file);
    const lecture = JSON.parse(readFileSync(file, 'utf8'));
    const many = structuredClone(lecture);
    const children = many.object.children.filter((child) => !child.type.endsWith('Light'));
    for (let i = 0; i < 64; ++i) {
        const y = 1 - (2 * i + 1) / 64, r = Math.sqrt(1 - y * y);
        children.push({ uuid: `00000009-0000-4000-8000-${String(i).padStart(12, '0')}`, type: 'PointLight', color: 0xDD6666,
            intensity: 0.6, distance: 0, decay: 2,
            matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4 * r * Math.cos(2.4 * i), 1.55 + 4 * y, 4 * r * Math.sin(2.4 * i), 1] });
    }
    many.object.children = children;
    writeWhole(join(folder, 'lights64.json'), JSON.stringify(many));
    return { "the lecture's lights": { file, json: lecture }, '64 point lights': { file: join(folder, 'lights64.json'), json: many } };
}

function page(name, library, json, count) {
    const file = join(folder, `${name}.html`);
    writeWhole(file, template.replace('LIBRARY', library).replace('FRAMES', count).replace('SCENE', () => JSON.stringify(json)));
    return file;
}

const results = [];
const add = (name, value, unit, target = null) =>
    results.push({ name, value: Number(value.toPrecision(4)), unit, target, ok: target === null ? null : value >= target });
let driver = '', revisions = {};

for (const [title, scene] of Object.entries(scenes())) {
    const cold = { lab: [], r146: [], newest: [] }, steady = { lab: [], r146: [], newest: [] };
    const pages = Object.fromEntries(Object.entries(versions).map(([name, library]) =>
        [name, [page(`${name}_cold`, library, scene.json, 0), page(`${name}_steady`, library, scene.json, frames)]]));
    for (let round = 0; round <= rounds; ++round) { // the first one fills caches
        process.stderr.write(`   ${title}: round ${round}/${rounds}\n`);
        cold.lab.push(timed(() => lab('scene_viewer', scene.file, '--frame', join(folder, 'lab.png'))));
        steady.lab.push(JSON.parse(lab('scene_viewer', scene.file, '--stats', '--frames', String(frames))).frame_ms.median);
        for (const name of Object.keys(versions)) {
            cold[name].push(timed(() => draw(pages[name][0])));
            const result = draw(pages[name][1]);
            steady[name].push(result.median);
            driver = result.driver;
            revisions[name] = result.revision;
        }
        if (round === 0) for (const list of [...Object.values(cold), ...Object.values(steady)]) list.length = 0;
    }
    const label = (name) => name === 'lab' ? 'the lab' : `three.js r${revisions[name]}`;
    for (const [kind, times] of [['process to pixels', cold], ['steady frame', steady]]) {
        for (const name of Object.keys(times)) add(`${title}: ${kind} of ${label(name)}`, median(times[name]), 'ms');
        for (const name of Object.keys(versions))
            add(`${title}: ${kind} of ${label(name)} to the lab`, median(times[name]) / median(times.lab), 'ratio',
                kind === 'process to pixels' && title !== '64 point lights' ? 10 : null);
    }
}
for (const name of Object.keys(versions)) // for people to look at
    inChromium(join(folder, `${name}_cold.html`), `--screenshot=${join(folder, name + '.png')}`);

add('Chromium reaches Mesa llvmpipe (else the drivers differ)', /llvmpipe/.test(driver) ? 1 : 0, 'yes=1');
writeWhole(join(out, 'threejs.json'), JSON.stringify({ part: 'threejs', machine: cpus()[0].model, cores: cpus().length, driver,
    version: lab('scene_viewer', '--version').trim().split(' ').pop(), date: new Date().toISOString().slice(0, 10), results }, null, 1) + '\n');
writeWhole(join(out, 'threejs.csv'), 'name,value,unit,target,ok\n' + results.map((r) =>
    `"${r.name}",${r.value},${r.unit},${r.target ?? ''},${r.ok === null ? '' : r.ok ? 'yes' : 'no'}`).join('\n') + '\n');
