// How the overlay looks, in light and dark; the picture reads its colours from elements of these classes.

export const STYLE = `
:host { all: initial; color-scheme: light dark; position: fixed; inset: 0; z-index: 2147483647; pointer-events: none;
  font: 12px/1.45 system-ui, sans-serif;
  --paper: light-dark(#fffffff0, #16181df0); --ink: light-dark(#1b1f27, #e8eaef); --faint: light-dark(#626b7a, #98a1b2);
  --edge: light-dark(#d5dae2, #343944); --idle: light-dark(#2563c9, #7fb0ff); --fired: light-dark(#14803c, #5fd48a);
  --lit: light-dark(#b45309, #fbbf5d); --ahead: light-dark(#a21caf, #f0a3fb) }
canvas { position: absolute; inset: 0; width: 100%; height: 100% }
i { display: none }
.idle { color: var(--idle) } .fired { color: var(--fired) } .lit { color: var(--lit) } .ahead { color: var(--ahead) } .paper { color: var(--paper) }
section { position: absolute; right: 12px; bottom: 12px; width: 296px; box-sizing: border-box; padding: 10px 12px; border-radius: 8px;
  background: var(--paper); color: var(--ink); border: 1px solid var(--edge); box-shadow: 0 4px 18px #0003 }
h1 { margin: 0 0 6px; font: 600 12px/1.45 system-ui, sans-serif }
dl { display: grid; grid-template-columns: repeat(5, auto); margin: 0 0 8px; gap: 0 4px }
dt { grid-row: 2; color: var(--faint); font-size: 11px }
dd { grid-row: 1; margin: 0; font-size: 15px; white-space: nowrap; font-variant-numeric: tabular-nums }
ol { margin: 0; padding: 6px 0 0; list-style: none; border-top: 1px solid var(--edge); min-height: 108px }
li { display: grid; grid-template-columns: 64px 1fr auto; gap: 6px; font-variant-numeric: tabular-nums }
li span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap }
li :first-child, li :last-child { color: var(--faint) }
[data-kind=fired] :nth-child(2) { color: var(--fired) }
[data-kind=hit] :nth-child(2) { color: var(--fired); font-weight: 600 }
[data-kind=withheld] :nth-child(2), [data-kind=withdrawn] :nth-child(2) { color: var(--faint) }
`;
