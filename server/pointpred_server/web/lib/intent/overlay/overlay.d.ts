/** Shows developers what is predicted, over the page. Returns what hides it. */
export function showOverlay(): () => void;
