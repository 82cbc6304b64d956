// Pointpred's own recordings as CSV, read in the page: docs/reference/recordings.md describes the columns.

import { count } from "../page/elements.js";

const MARK = "# pointpred:";
const NEEDED = ["user", "trial", "t_s", "x_px", "y_px"];
const MOST_BYTES = 64 * 1024 * 1024;

/** The cells of a line; words may stand in quotes, with quotes doubled inside. */
function cells(text) {
  if (!text.includes('"')) return text.split(",");
  return [...text.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain);
}

/** What the first line says of the table, where it is a header. */
function headerOf(line) {
  if (!line?.startsWith(MARK)) return {};
  const refuse = (what) => {
    throw new Error(`its ${MARK} line is ${what}: ${line.slice(MARK.length, 60).trim()}`);
  };
  let found = null;
  try {
    found = JSON.parse(line.slice(MARK.length));
  } catch {
    refuse("not JSON");
  }
  if (found === null || typeof found !== "object" || Array.isArray(found)) refuse("no JSON object");
  return found;
}

/** A table: the header, the names of the columns, and rows of cells. */
export function parse(text) {
  const lines = text.replace(/^\uFEFF/, "").split(/\r?\n/).filter((line) => line.trim() !== "");
  const header = headerOf(lines[0]);
  if (lines[0]?.startsWith(MARK)) lines.shift();
  const columns = cells(lines.shift() ?? "").map((name) => name.trim());
  const rows = lines.map((line, row) => {
    const found = cells(line);
    if (found.length !== columns.length) throw new Error(`row ${row} has ${found.length} cells, expected ${columns.length}`);
    return found;
  });
  if (header.rows !== undefined && header.rows !== rows.length) throw new Error(`${rows.length} rows, its header says ${header.rows}`);
  return { header, columns, rows };
}

const cell = (value) => (value === undefined || value === "" ? null : Number(value));

/** Targets by user and trial. @returns {Map<string, {x: number, y: number, width: number}>} */
function targets({ columns, rows }) {
  const at = (name) => columns.indexOf(name);
  const found = new Map();
  for (const row of rows) {
    const [x, y, width] = ["target_x", "target_y", "target_w"].map((name) => cell(row[at(name)]));
    if (x !== null && y !== null) found.set(`${row[at("user")]}\n${row[at("trial")]}`, { x, y, width: width ?? 0 });
  }
  return found;
}

/** Why a movement cannot be shown; null where it can. */
function flaw({ rows }) {
  if (rows.length < 2) return "it has fewer than two rows";
  for (const [i, row] of rows.entries()) {
    const bad = [0, 1, 2].find((at) => row[at] === null || !Number.isFinite(row[at]));
    if (bad !== undefined) return `${NEEDED[2 + bad]} in its row ${i} is ${row[bad] === null ? "empty" : "no finite number"}`;
    if (i > 0 && row[0] < rows[i - 1][0]) return `time runs backwards at its row ${i}`;
  }
  return null;
}

/** The trials of a table of samples: rows as the service takes them; unusable ones are counted. */
function trials({ columns, rows }, goals) {
  const missing = NEEDED.find((name) => !columns.includes(name));
  if (missing) throw new Error(`the column ${missing} is missing; found ${columns.slice(0, 8).join(", ").slice(0, 80)}`);
  const [user, trial, ...values] = [...NEEDED, "dx_counts", "dy_counts", "buttons"].map((name) => columns.indexOf(name));
  const found = new Map();
  for (const row of rows) {
    const key = `${row[user]}\n${row[trial]}`;
    if (!found.has(key)) found.set(key, { user: row[user], name: row[trial], target: goals.get(key) ?? null, rows: [] });
    const [t, x, y, dx, dy, buttons] = values.map((at) => cell(row[at]));
    found.get(key).rows.push([t, x, y, dx, dy, buttons ?? 0]);
  }
  const all = [...found.values()];
  const kept = all.filter((one) => flaw(one) === null);
  const lame = all.find((one) => flaw(one) !== null);
  const reason = lame === undefined ? "" : `${lame.user} ${lame.name}: ${flaw(lame)}`;
  if (kept.length === 0) throw new Error(`${count(all.length, "movement")}, none of which can be shown${reason && `; ${reason}`}`);
  return { kept, left: all.length - kept.length, reason };
}

/** What `act` finds in a file; what it complains of is said with the file's name. */
function within({ name }, act) {
  try {
    return act();
  } catch (error) {
    throw new Error(`${name}: ${error.message}`);
  }
}

/** The text of a file, or of a part of it. */
function textOf(part, { name }) {
  return part.text().catch(() => {
    throw new Error(`${name} cannot be read: is it a folder?`);
  });
}

/** The table in a file. */
async function table(file) {
  if (file.size > MOST_BYTES) throw new Error(`${file.name} is larger than ${MOST_BYTES / 1048576} MiB; pointpred score reads it`);
  const text = await textOf(file, file);
  return { file, text, ...within(file, () => parse(text)) };
}

/** The one table of samples among some, and the one of trials, if there is one. */
function sorted(tables) {
  const holding = (column) => tables.filter(({ columns }) => columns.includes(column));
  const samples = holding("t_s"), described = holding("target_x");
  const names = (some) => some.map(({ file }) => file.name).join(", ");
  const strange = tables.filter((one) => !samples.includes(one) && !described.includes(one));
  if (strange.length) throw new Error(`${names(strange)} is no table of samples, which has the columns ${NEEDED.join(", ")}, nor one of trials`);
  if (samples.length === 0) throw new Error(`${names(tables)} is no table of samples: its trials alone show nothing`);
  for (const many of [samples, described]) if (many.length > 1) throw new Error(`one recording at a time: ${names(many)} are several`);
  return [samples[0], described[0]];
}

/** Whether the page reads a file itself: it names a column of ours, or says so in its first line. @param {File} file */
export async function isOwn(file) {
  const head = await textOf(file.slice(0, 4096), file);
  const names = cells(head.replace(/^\uFEFF/, "").split(/\r?\n/, 1)[0]).map((name) => name.trim());
  return head.startsWith(MARK) || NEEDED.every((name) => names.includes(name)) || ["user", "trial", "target_x"].every((name) => names.includes(name));
}

/**
 * Reads a samples file, with its trials file where both are given.
 * @param {File[]} files
 * @returns {Promise<{name: string, csv: string, dpi: number, cpi: number|null, simulated: boolean, left: number, reason: string,
 *   movements: {name: string, user: string, rows: number[][], target: object|null}[]}>}
 */
export async function readFiles(files) {
  const [samples, described] = sorted(await Promise.all(files.map(table)));
  const { file, text, header } = samples;
  const { kept, left, reason } = within(file, () => trials(samples, described ? targets(described) : new Map()));
  return {
    name: header.name ?? file.name, csv: text, left, reason, movements: kept,
    dpi: header.provenance?.dpi ?? 96, cpi: header.provenance?.cpi ?? null, simulated: header.provenance?.simulated === true,
  };
}
