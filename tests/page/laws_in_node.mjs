// The comparison of laws.js in Node: reads cases from its input, writes what came of them.

import { readFileSync } from "node:fs";
import { compareAll } from "./laws.js";

const LAWS = new URL("../../server/pointpred_server/web/lib/laws", import.meta.url).href;
process.stdout.write(JSON.stringify(await compareAll(LAWS, JSON.parse(readFileSync(0, "utf8")))));
