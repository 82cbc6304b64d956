// The button that copies the snippet of code.

import { part, write } from "./elements.js";

const SHOWN_MS = 2000;

const button = part("snippet-copy"),
  code = part("snippet");

async function copy() {
  try {
    await navigator.clipboard.writeText(code.textContent);
    write(button, "Copied");
  } catch {
    window.getSelection()?.selectAllChildren(code); // a page that was not loaded by HTTPS may not write to the clipboard
    write(button, "Selected");
  }
  setTimeout(() => write(button, "Copy"), SHOWN_MS);
}

button.addEventListener("click", copy);
