import { facts } from "../dom.js";
import { number, percent, quantity } from "../units.js";

export function agreement(data) {
  const a = data.agreement;
  if (!a) {
    return { title: "Agreement with a video", missing: "No agreement.json is here; porefines compare RUN TRACKS -o RUN/compare writes one." };
  }
  return {
    id: "agreement",
    title: "Agreement with the video",
    fill(section) {
      section.append(facts([
        ["agreement", number(a.agreement, 4)],
        ["mean speed", `correlation ${number(a.mean_speed_correlation, 3)}, off by ${percent(a.mean_speed_nrms)} (rms), ${percent(a.mean_speed_largest_difference)} at most`],
        ["σ x", `off by ${percent(a.sigma_x_nrms)}, ${percent(a.sigma_x_largest_difference)} at most`],
        ["σ y", `off by ${percent(a.sigma_y_nrms)}, ${percent(a.sigma_y_largest_difference)} at most`],
        ["speed histograms overlap", percent(a.speed_histogram_overlap)],
        ["streamlines overlap", percent(a.streamline_overlap)],
        ["retained places matched", percent(a.retained_matched)],
        ["alignment", `shift ${quantity(a.alignment_shift_x_m, "m", 3)}, ${quantity(a.alignment_shift_y_m, "m", 3)}; angle ${number((a.alignment_angle_rad * 180) / Math.PI, 3)}°, scale ${number(a.alignment_scale, 4)}`],
      ]));
    },
  };
}
