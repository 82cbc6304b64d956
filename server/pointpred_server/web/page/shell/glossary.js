// Explanations of the terms in the page: each part of the page names the terms that it uses.

const TERMS = {
  phase: ["phase", "still: the pointer rests; ballistic or corrective: the part of the movement it is in"],
  ballistic: ["ballistic", "the first, fast part of a movement, aimed but not yet corrected by eye"],
  corrective: ["corrective", "the slow part near the target, in which the hand corrects its aim"],
  skill: ["skill", "1 − error / hold: 1 is perfect, 0 no better than no prediction, below 0 worse"],
  left: ["time left", "predicted time until the movement ends"],
  region: [
    "region",
    "where the endpoint lies with a given probability, as the predictor claims: 50 % for the tinted ellipse, 80 % for the thin one. Its size is length × breadth of the tinted one. Some predictors give no region",
  ],
  proposed: [
    "tile proposed",
    "the prediction is confident enough that you are heading for this tile: a program could now load what the tile opens",
  ],
  near: [
    "predicted within 40 px",
    "from then until you arrived, every predicted endpoint was within 40 px of where you stopped",
  ],
  arrived: [
    "arrived",
    "from then on the pointer stayed within 8 px of where it stopped (3 % of the distance, if that is more)",
  ],
  delay: ["delay", "time from sending an event to receiving its prediction, median of the last second"],
  drem: ["DREM", "dynamic regressor extension and mixing: the estimator that switched uses in the corrective phase"],
  differentiator: ["differentiator", "computes speed and acceleration from positions"],
  ktm: ["ktm", "kinematic template matching: compares the movement with earlier ones of the same session"],
  kep: ["kep", "kinematic endpoint prediction: extends a curve of speed over distance to where the speed is zero"],
};

function entry(texts) {
  const [term, meaning] = texts.map((text, i) => {
    const element = document.createElement(i === 0 ? "dt" : "dd");
    element.textContent = text;
    return element;
  });
  const pair = document.createElement("div");
  pair.append(term, meaning);
  return pair;
}

/** Fills each `details` that names terms in `data-terms`. */
function explainTerms() {
  for (const details of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("details[data-terms]"))) {
    const summary = document.createElement("summary");
    summary.textContent = "What these terms mean";
    const list = document.createElement("dl");
    list.append(
      ...String(details.dataset.terms)
        .split(" ")
        .map((name) => entry(TERMS[name])),
    );
    details.replaceChildren(summary, list);
  }
}

/** Adds predictors to such a list, with their titles. @param {HTMLElement} details @param {{name: string, title: string}[]} predictors */
export function explainPredictors(details, predictors) {
  details.querySelector("dl")?.append(...predictors.map(({ name, title }) => entry([name, title])));
}

explainTerms();
