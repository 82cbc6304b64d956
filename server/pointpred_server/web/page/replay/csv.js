// Pointpred's own recordings as CSV, read in the page: docs/reference/recordings.md describes the columns.

import { count } from "../shell/numbers.js";

const MARK = "# pointpred:";
const REQUIRED = ["user", "trial", "t_s", "x_px", "y_px"];
const OPTIONAL = ["dx_counts", "dy_counts", "buttons"];
const MIB = 1024 * 1024;
const MOST_BYTES = 64 * MIB;
const HEAD_BYTES = 4096;

/** A file that cannot be opened. */
class FileError extends Error {}

/** The cells of a line; a cell may be quoted, with quotes doubled inside. */
function cells(text) {
  if (!text.includes('"')) return text.split(",");
  return [...text.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(
    ([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain,
  );
}

/** The header in the first line, if there is one. */
function parseHeader(line) {
  if (!line?.startsWith(MARK)) return {};
  const refuse = (what) => {
    throw new FileError(`its ${MARK} line is ${what}: ${line.slice(MARK.length, 60).trim()}`);
  };
  /** @type {any} */
  let header = null;
  try {
    header = JSON.parse(line.slice(MARK.length));
  } catch {
    refuse("not JSON");
  }
  if (header === null || typeof header !== "object" || Array.isArray(header)) refuse("not a JSON object");
  return header;
}

/** A table: the header, the names of the columns, and rows of cells. */
export function parse(text) {
  const lines = text
    .replace(/^\uFEFF/, "")
    .split(/\r?\n/)
    .filter((line) => line.trim() !== "");
  const header = parseHeader(lines[0]);
  if (lines[0]?.startsWith(MARK)) lines.shift();
  const columns = cells(lines.shift() ?? "").map((name) => name.trim());
  const rows = lines.map((line, i) => {
    const row = cells(line);
    if (row.length !== columns.length)
      throw new FileError(`row ${i} has ${row.length} cells, expected ${columns.length}`);
    return row;
  });
  if (header.rows !== undefined && header.rows !== rows.length)
    throw new FileError(`${rows.length} rows, but its header says ${header.rows}`);
  return { header, columns, rows };
}

const numberIn = (cell) => (cell === undefined || cell === "" ? null : Number(cell));

/** The targets in a table of trials, by user and trial. @returns {Map<string, {x: number, y: number, width: number}>} */
function targetsIn({ columns, rows }) {
  const at = (name) => columns.indexOf(name);
  const targets = new Map();
  for (const row of rows) {
    const [x, y, width] = ["target_x", "target_y", "target_w"].map((name) => numberIn(row[at(name)]));
    if (x !== null && y !== null) targets.set(`${row[at("user")]}\n${row[at("trial")]}`, { x, y, width: width ?? 0 });
  }
  return targets;
}

/** Why a movement cannot be shown; null if it can. */
function problemWith({ rows }) {
  if (rows.length < 2) return "it has fewer than two rows";
  for (const [i, row] of rows.entries()) {
    const bad = [0, 1, 2].find((at) => row[at] === null || !Number.isFinite(row[at]));
    if (bad !== undefined)
      return `${REQUIRED[2 + bad]} in its row ${i} is ${row[bad] === null ? "empty" : "not a finite number"}`;
    if (i > 0 && row[0] < rows[i - 1][0]) return `the time decreases at its row ${i}`;
  }
  return null;
}

/** The movements in a table of samples, with rows as the service takes them; those that cannot be shown are counted. */
function movementsIn({ columns, rows }, targets) {
  const missing = REQUIRED.find((name) => !columns.includes(name));
  if (missing)
    throw new FileError(
      `the column ${missing} is missing; its columns are ${columns.slice(0, 8).join(", ").slice(0, 80)}`,
    );
  const [user, trial, ...values] = [...REQUIRED, ...OPTIONAL].map((name) => columns.indexOf(name));
  const byKey = new Map();
  for (const row of rows) {
    const key = `${row[user]}\n${row[trial]}`;
    if (!byKey.has(key))
      byKey.set(key, { user: row[user], name: row[trial], target: targets.get(key) ?? null, rows: [] });
    const [t, x, y, dx, dy, buttons] = values.map((at) => numberIn(row[at]));
    byKey.get(key).rows.push([t, x, y, dx, dy, buttons ?? 0]);
  }
  const all = [...byKey.values()];
  const movements = all.filter((one) => problemWith(one) === null);
  const unusable = all.find((one) => problemWith(one) !== null);
  const reason = unusable === undefined ? "" : `${unusable.user} ${unusable.name}: ${problemWith(unusable)}`;
  if (movements.length === 0)
    throw new FileError(`${count(all.length, "movement")}, none of which can be shown${reason && `; ${reason}`}`);
  return { movements, skipped: all.length - movements.length, reason };
}

/** Calls `act`; the message of a FileError then begins with the name of the file. */
function naming({ name }, act) {
  try {
    return act();
  } catch (error) {
    throw error instanceof FileError ? new FileError(`${name}: ${error.message}`) : error;
  }
}

/** The text of a file, or of a part of it. */
function textOf(part, { name }) {
  return part.text().catch(() => {
    throw new FileError(`${name} cannot be read: is it a folder?`);
  });
}

async function readTable(file) {
  if (!(await isOwnFormat(file)))
    throw new FileError(`${file.name} is not pointpred's own CSV; the command pointpred convert makes one of it`);
  if (file.size > MOST_BYTES)
    throw new FileError(`${file.name} is larger than ${MOST_BYTES / MIB} MiB; use pointpred score`);
  const text = await textOf(file, file);
  return { file, ...naming(file, () => parse(text)) };
}

/** The table of samples, and the table of trials if there is one. */
function assignRoles(tables) {
  const withColumn = (column) => tables.filter(({ columns }) => columns.includes(column));
  const samples = withColumn("t_s"),
    trials = withColumn("target_x");
  const names = (some) => some.map(({ file }) => file.name).join(", ");
  const unknown = tables.filter((one) => !samples.includes(one) && !trials.includes(one));
  if (unknown.length)
    throw new FileError(
      `${names(unknown)} has neither the columns of samples (${REQUIRED.join(", ")}) nor those of trials`,
    );
  if (samples.length === 0) throw new FileError(`${names(tables)} has trials but no samples`);
  for (const several of [samples, trials])
    if (several.length > 1) throw new FileError(`only one recording can be opened at a time, not ${names(several)}`);
  return [samples[0], trials[0]];
}

/** Whether a file is in pointpred's own format: its first line is our header, or names our columns. @param {File} file */
async function isOwnFormat(file) {
  const head = await textOf(file.slice(0, HEAD_BYTES), file);
  const names = cells(head.replace(/^\uFEFF/, "").split(/\r?\n/, 1)[0]).map((name) => name.trim());
  return (
    head.startsWith(MARK) ||
    REQUIRED.every((name) => names.includes(name)) ||
    ["user", "trial", "target_x"].every((name) => names.includes(name))
  );
}

/**
 * Reads a table of samples, and its table of trials if it is among the files.
 * @param {File[]} files
 * @returns {Promise<{name: string, dpi: number, cpi: number|null, simulated: boolean, skipped: number, reason: string,
 *   movements: {name: string, user: string, rows: import("../../lib/index.d.ts").EventRow[], target: import("../../lib/index.d.ts").Goal|null}[]}>} `skipped` movements cannot be shown,
 *   the first for this `reason`
 */
export async function readFiles(files) {
  const [samples, trials] = assignRoles(await Promise.all(files.map(readTable)));
  const { file, header } = samples;
  const { movements, skipped, reason } = naming(file, () =>
    movementsIn(samples, trials ? targetsIn(trials) : new Map()),
  );
  return {
    name: header.name ?? file.name,
    skipped,
    reason,
    movements,
    dpi: header.provenance?.dpi ?? 96,
    cpi: header.provenance?.cpi ?? null,
    simulated: header.provenance?.simulated === true,
  };
}
