import type { HandName } from "./protocol";

/** Colors of the hands, distinguishable with color vision deficiency, on light and on dark. */
export const handColors: Record<HandName, string> = {
  left: "#e69f00",
  right: "#0072b2",
  both: "#a65fb5",
  any: "#6c7482",
};

/** Colors of the rings about the world's axes; the patterns of the rings differ, too. */
export const axisColors = ["#e5484d", "#2f9e52", "#3b7dff"] as const;

export const guideColors = {
  plane: "#6470e8",
  plumbLine: "#5d6678",
  ghost: "#6470e8",
  hover: "#5b68f0",
  selected: "#0a9396",
  marker: "#d6336c",
  tool: "#17854a",
  measure: "#b02a8f",
};
