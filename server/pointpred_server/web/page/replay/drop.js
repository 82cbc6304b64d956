// Files dragged onto the page from outside the browser.

/** Whether files are dragged; for text and links the browser keeps its own behaviour. @param {DragEvent} event */
const holdsFiles = (event) => event.dataTransfer?.types.includes("Files") ?? false;

/**
 * Accepts files dropped anywhere on the page while `area` is visible, and highlights it while files are over the page.
 * @param {HTMLElement} area gets the class "over" @param {(files: File[]) => void} onFiles
 */
export function acceptFiles(area, onFiles) {
  /** @param {(event: DragEvent) => void} handle @returns {(event: DragEvent) => void} */
  const handler = (handle) => (event) => {
    if (area.offsetParent === null || !holdsFiles(event)) return; // another view is open, or no file is dragged
    event.preventDefault();
    handle(event);
  };
  const enter = handler((event) => {
    /** @type {DataTransfer} */ (event.dataTransfer).dropEffect = "copy";
    area.classList.add("over");
  });
  document.addEventListener("dragenter", enter);
  document.addEventListener("dragover", enter);
  document.addEventListener("dragleave", (event) => event.relatedTarget === null && area.classList.remove("over"));
  document.addEventListener(
    "drop",
    handler((event) => {
      area.classList.remove("over");
      onFiles([.../** @type {DataTransfer} */ (event.dataTransfer).files]);
    }),
  );
}

/** Refuses files that no view accepts: the browser would open them instead of the page. */
export function refuseFiles() {
  for (const kind of /** @type {const} */ (["dragenter", "dragover", "drop"])) {
    window.addEventListener(kind, (event) => {
      if (event.defaultPrevented || !holdsFiles(event)) return;
      event.preventDefault();
      /** @type {DataTransfer} */ (event.dataTransfer).dropEffect = "none";
    });
  }
}
