// A circle run as a recording in pointpred's own format: a table of samples and a table of trials, both CSV.

const SAMPLES = ["dataset", "user", "trial", "t_s", "x_px", "y_px", "buttons"];
const TRIALS = [
  "dataset",
  "user",
  "trial",
  "target_x",
  "target_y",
  "target_w",
  "n_samples",
  "block",
  "distance_px",
  "from_x",
  "from_y",
  "hit",
  "started_s",
  "start_x",
  "start_y",
];

/** A table as CSV: numbers read back exactly, null is an empty cell. */
function csv(header, columns, rows) {
  const firstLine = `# pointpred: ${JSON.stringify({ ...header, version: 1, rows: rows.length })}`;
  return [firstLine, columns.join(","), ...rows.map((cells) => cells.join(","))].join("\n") + "\n";
}

const nameOf = ({ sequence: { block }, number }) => `block-${block}-movement-${number}`;

/**
 * The two files of a run. Times are of the browser's clock, positions are px from the upper left corner of the picture.
 * A movement without samples (two presses at once) is left out.
 * @param {import("../study/task.js").Trial[]} trials
 * @param {string} name of the set @param {string} user who moved
 * @returns {{samples: {name: string, text: string}, trials: {name: string, text: string}}}
 */
export function recording(trials, name, user) {
  const complete = trials.filter(({ rows }) => rows.length);
  const provenance = {
    format: "circle of the live page",
    clock: "seconds of the browser's clock",
    dpi: 96,
    simulated: false,
  };
  const skipped = trials.filter(({ rows }) => !rows.length).map((trial) => [nameOf(trial), "no samples", null, user]);
  const samples = complete.flatMap((trial) =>
    trial.rows.map(([t, x, y, , , buttons]) => [name, user, nameOf(trial), t, x, y, buttons]),
  );
  const rows = complete.map((trial) => [
    name,
    user,
    nameOf(trial),
    ...trial.target,
    trial.sequence.width,
    trial.rows.length,
    trial.sequence.block,
    trial.sequence.distance,
    ...trial.from,
    Number(trial.hit),
    ...trial.start.slice(0, 3),
  ]);
  return {
    samples: { name: `${name}_samples.csv`, text: csv({ name, provenance, skipped, notes: [] }, SAMPLES, samples) },
    trials: { name: `${name}_trials.csv`, text: csv({ name, text: [] }, TRIALS, rows) },
  };
}
