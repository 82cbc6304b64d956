// What a test gives to a script, and what the script answers.

import { text } from "node:stream/consumers";

export const given = async () => JSON.parse(await text(process.stdin));
export const answer = (value) => process.stdout.write(JSON.stringify(value));
export const numbers = (row) => row.map((value) => value ?? NaN);
/** What a call gives, or what it throws, as a program reads it. */
export async function attempt(call) {
  try {
    return await call();
  } catch ({ name, code, field, value, message }) {
    return { error: name, code, field, value, message };
  }
}
