// The coefficients as the page has them.
import { writeFileSync } from "node:fs";
import { COEFFICIENTS } from "../../server/pointpred_server/web/lib/laws/kinematic.js";

writeFileSync(1, JSON.stringify(Array.from(COEFFICIENTS)));
