// The comparison of laws.js in Node: reads cases from its input, writes what came of them.

import { readFileSync } from "node:fs";
import { compareAll } from "./laws.js";

const LAWS = new URL("../../server/pointpred_server/web/lib/laws", import.meta.url).href;
const packed = readFileSync(new URL(`${LAWS}/kinematic.f32`));
const bytes = packed.buffer.slice(packed.byteOffset, packed.byteOffset + packed.byteLength);
process.stdout.write(JSON.stringify(await compareAll(LAWS, JSON.parse(readFileSync(0, "utf8")), bytes)));
