// Opens the live view at once where the address names it: modules of the other views may still be on their way.

import { open } from "./view.js";

if (["", "#live"].includes(window.location.hash)) open().catch(() => {}); // page.js opens it too, and says what is wrong
