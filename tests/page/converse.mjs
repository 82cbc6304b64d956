// A session in the page: each frame is a message, or rows of events; answers by frame.

import { PageSession } from "../../server/pointpred_server/web/lib/prediction/session.js";
import { answer, given } from "./given.mjs";

let heard = [];
const session = new PageSession((message) => heard.push(message)),
  answers = [];
for (const frame of await given()) {
  if (Array.isArray(frame)) session.receiveRows(frame);
  else await session.receive(frame);
  answers.push(heard);
  heard = [];
}
answer(answers);
