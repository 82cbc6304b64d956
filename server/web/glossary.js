// The field's words, explained where they stand: a part of the page names the words that it uses.

const WORDS = {
  ballistic: ["ballistic", "the first, fast part of a movement, aimed but not yet corrected by eye"],
  corrective: ["corrective", "the slow part near the target, in which the hand corrects its aim"],
  error: ["error", "distance from the predicted endpoint to where the movement ended, averaged over the time of the movement"],
  hold: ["hold", "no prediction: it says that the movement ends where the cursor is now. Every predictor is compared with it"],
  ratio: ["error / hold", "a predictor's error divided by hold's on the same movements: below 1 is better than no prediction"],
  skill: ["skill", "1 − error / hold: 1 is perfect, 0 no better than no prediction, below 0 worse"],
  interval: ["95 % interval", "the range of error / hold that other movements or people like these would give. One movement has none"],
  answered: ["answered", "share of the pointer's events for which the predictor gave an endpoint"],
  ktm: ["ktm", "kinematic template matching: compares the movement with earlier ones of the same session"],
  kep: ["kep", "kinematic endpoint prediction: extends a curve of speed over distance to where the speed is zero"],
};

function entry(name) {
  const [term, meaning] = WORDS[name].map((text, i) => {
    const element = document.createElement(i === 0 ? "dt" : "dd");
    element.textContent = text;
    return element;
  });
  const pair = document.createElement("div");
  pair.append(term, meaning);
  return pair;
}

/** Fills each `details` that names words in `data-words`. */
export function explainWords() {
  for (const details of document.querySelectorAll("details[data-words]")) {
    const summary = document.createElement("summary");
    summary.textContent = "What these words mean";
    const list = document.createElement("dl");
    list.append(...details.dataset.words.split(" ").map(entry));
    details.replaceChildren(summary, list);
  }
}
