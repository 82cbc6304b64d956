// What the Circle view computes of trials.
import { readFileSync } from "node:fs";
import { statistics } from "../../server/pointpred_server/web/page/circle/statistics.js";

process.stdout.write(JSON.stringify(statistics(JSON.parse(readFileSync(0, "utf8")))));
