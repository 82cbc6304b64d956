// Every page of the site runs this: what the generator and its theme leave to be done.

if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false; // excerpts are fetched, which no browser allows there

addEventListener("DOMContentLoaded", () => {
  for (const caption of document.querySelectorAll(".caption[role=heading]")) caption.ariaLevel = "2";
  for (const part of document.querySelectorAll("pre, .table-wrapper"))
    if (part.scrollWidth > part.clientWidth) part.tabIndex = 0; // so that the keyboard can scroll it
  document.querySelector(".sidebar-drawer")?.setAttribute("aria-label", "All pages");
  document.querySelector(".toc-drawer")?.setAttribute("aria-label", "On this page");
});
