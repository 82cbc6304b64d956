// What proposals of places need, loaded when somebody asks for them.

export { build } from "../prediction/build.js";
export { PlaceChooser } from "../prediction/place-chooser.js";
