// Pointpred's own recordings as CSV, read in the page: docs/recordings.md describes the columns.

const MARK = "# pointpred:";
const NEEDED = ["user", "trial", "t_s", "x_px", "y_px"];
const MOST_BYTES = 64 * 1024 * 1024;

/** The cells of a line; words may stand in quotes, with quotes doubled inside. */
function cells(text) {
  if (!text.includes('"')) return text.split(",");
  return [...text.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain);
}

/** A table with its header: the JSON of the first line, and rows as objects from column to cell. */
export function parse(text) {
  const lines = text.replace(/^\uFEFF/, "").split(/\r?\n/).filter((line) => line.trim() !== "");
  const header = lines[0]?.startsWith(MARK) ? JSON.parse(lines.shift().slice(MARK.length)) : {};
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

/** The trials of a table of samples: rows as the service takes them; unusable ones are counted. */
function trials({ columns, rows }, goals) {
  const missing = NEEDED.find((name) => !columns.includes(name));
  if (missing) throw new Error(`the column ${missing} is missing; found ${columns.slice(0, 8).join(", ")}`);
  const [user, trial, ...values] = [...NEEDED, "dx_counts", "dy_counts", "buttons"].map((name) => columns.indexOf(name));
  const found = new Map();
  for (const row of rows) {
    const key = `${row[user]}\n${row[trial]}`;
    if (!found.has(key)) found.set(key, { user: row[user], name: row[trial], target: goals.get(key) ?? null, rows: [] });
    const [t, x, y, dx, dy, buttons] = values.map((at) => cell(row[at]));
    found.get(key).rows.push([t, x, y, dx, dy, buttons ?? 0]);
  }
  const all = [...found.values()];
  const sound = ({ rows: own }) =>
    own.length > 1 && own.every(([t, x, y], i) => [t, x, y].every((v) => v !== null && Number.isFinite(v)) && (i === 0 || t >= own[i - 1][0]));
  const kept = all.filter(sound);
  if (kept.length === 0) throw new Error(`none of its ${all.length} movements can be shown`);
  return { kept, left: all.length - kept.length };
}

/**
 * Reads a samples file, with its trials file where both are given.
 * @param {File[]} files
 * @returns {Promise<{name: string, csv: string, dpi: number, cpi: number|null, simulated: boolean, left: number,
 *   movements: {name: string, user: string, rows: number[][], target: object|null}[]}>}
 */
export async function readFiles(files) {
  const large = files.find(({ size }) => size > MOST_BYTES);
  if (large) throw new Error(`${large.name} is larger than ${MOST_BYTES / 1048576} MiB; pointpred score reads it`);
  const texts = await Promise.all(files.map((file) => file.text()));
  const tables = texts.map(parse);
  const which = tables.findIndex(({ columns }) => columns.includes("t_s"));
  if (which < 0) throw new Error("no table of samples: expected a file with the columns user, trial, t_s, x_px, y_px");
  const described = tables.find(({ columns }) => columns.includes("target_x"));
  const { header } = tables[which];
  const { kept, left } = trials(tables[which], described ? targets(described) : new Map());
  return {
    name: header.name ?? files[which].name, csv: texts[which], left, movements: kept,
    dpi: header.provenance?.dpi ?? 96, cpi: header.provenance?.cpi ?? null, simulated: header.provenance?.simulated === true,
  };
}
