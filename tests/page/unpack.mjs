// Unpacks what is given as the bytes of a file of coefficients; writes how many numbers it holds, or the error.
import { readFileSync } from "node:fs";
import { unpack } from "../../server/pointpred_server/web/lib/laws/coefficients.js";

const bytes = Uint8Array.from(JSON.parse(readFileSync(0, "utf8")));
let answer;
try {
  answer = unpack(bytes.buffer).length;
} catch ({ message }) {
  answer = message;
}
process.stdout.write(JSON.stringify(answer));
