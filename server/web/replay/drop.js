// Files dragged onto a view from outside the browser.

/** Whether files are dragged: text and links keep what the browser does with them. */
export const holdsFiles = (dragged) => dragged.dataTransfer?.types.includes("Files") ?? false;

/**
 * Takes files dropped anywhere on the page while `area` is to be seen, and marks it while they hang over the page.
 * @param {HTMLElement} area gets the class "over" @param {(files: File[]) => void} given
 */
export function acceptFiles(area, given) {
  const handle = (act) => (dragged) => {
    if (area.offsetParent === null || !holdsFiles(dragged)) return; // another view is open, or no file
    dragged.preventDefault();
    act(dragged);
  };
  const over = handle((dragged) => {
    dragged.dataTransfer.dropEffect = "copy";
    area.classList.add("over");
  });
  document.addEventListener("dragenter", over);
  document.addEventListener("dragover", over);
  document.addEventListener("dragleave", (dragged) => dragged.relatedTarget === null && area.classList.remove("over"));
  document.addEventListener("drop", handle((dragged) => {
    area.classList.remove("over");
    given([...dragged.dataTransfer.files]);
  }));
}

/** Where nothing takes files, a drop would open them instead of the page: that is kept from happening. */
export function refuseFiles() {
  for (const kind of ["dragenter", "dragover", "drop"]) {
    window.addEventListener(kind, (dragged) => {
      if (dragged.defaultPrevented || !holdsFiles(dragged)) return;
      dragged.preventDefault();
      dragged.dataTransfer.dropEffect = "none";
    });
  }
}
