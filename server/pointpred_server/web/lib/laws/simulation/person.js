// Written by `make laws` from person.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
export const NORMALS = 18;
export function between(skill, novice, expert, scatter) {
  return (novice + skill * (expert - novice)) * Math.exp(scatter);
}
export function grow(traits, skill, normals, traits_at = 0) {
  const n = new Float64Array(NORMALS);
  for (let i = 0; i < NORMALS; i++) {
    n[i] = smaller(larger(normals[i], -2), 2);
  }
  traits[traits_at] = skill;
  traits[traits_at + 14] = between(skill, 7.5, 10.5, 0.08 * n[0]);
  traits[traits_at + 1] = between(skill, 0.34, 0.24, 0.1 * n[1]);
  traits[traits_at + 2] = between(skill, 0.085, 0.06, 0.08 * n[2]);
  traits[traits_at + 3] = smaller(larger(0.08 + 0.84 * skill, 0), 1);
  traits[traits_at + 4] = between(skill, 0.96, 0.98, 0.03 * n[3]);
  traits[traits_at + 5] = between(skill, 0.12, 0.05, 0.1 * n[4]);
  traits[traits_at + 6] = between(skill, 0.12, 0.05, 0.15 * n[5]);
  traits[traits_at + 7] = (0.08 + 0.08 * (1 - skill)) * normals[6];
  traits[traits_at + 8] = smaller(larger(0.1 + 0.08 * normals[7], -0.1), 0.4);
  traits[traits_at + 9] = between(skill, 0.26, 0.2, 0.12 * n[8]);
  traits[traits_at + 10] = between(skill, 0.07, 0.03, 0.2 * n[9]);
  traits[traits_at + 11] = between(skill, 0.17, 0.1, 0.15 * n[10]);
  traits[traits_at + 12] = between(skill, 0.095, 0.08, 0.15 * n[11]);
  traits[traits_at + 13] = 2 * between(skill, 1.05, 1.05, 0.06 * n[12]) * traits[traits_at + 14];
  traits[traits_at + 15] = between(skill, 0.12, 0.095, 0.08 * n[13]);
  traits[traits_at + 16] = between(skill, 0.024, 0.018, 0.1 * n[14]);
  traits[traits_at + 17] = between(skill, 0.035, 0.025, 0.15 * n[15]);
  traits[traits_at + 18] = between(skill, 0.0007, 0.0004, 0.2 * n[16]);
  traits[traits_at + 19] = between(skill, 0.16, 0.12, 0.1 * n[17]);
}
