/**
 * Words that a link writes as a number. Part of the format: only ever append, never reorder or remove. A reader
 * that meets a number beyond its list knows that the link was made by a newer one.
 */
export const WORDS: readonly string[] =
  // The document and what every step has.
  (
    'lissom models steps outputs file builtin step id type model name hidden ' +
    // deform
    'deform roi handles method options kind vertices matrix position ranges all region point ' +
    'implicit iterative naive isolines removeShear scaleDetails iterations coherenceRing ' +
    // merge, transfer
    'merge source target mode independent dependent boundaries keys transition sourceWidth targetWidth weight ' +
    'optimalBoundary sourceRegion feature targetRegion placement smoothing transfer like ' +
    // hair
    'hair scalp grid resolution streams points fade partings tilt sigma height ponytails spine section profiles ' +
    'tightness strands count seed detail clump curl frizz ' +
    // curves, match
    'curves surface skeleton contour rest posed twist scale rigid links match markers edgeLength sharpAngle ' +
    'blend dress ' +
    // built-in models
    'dinosaur critter octopus horse cow bar bunny head-female head-male head-elf body-female body-male ' +
    // more of hair
    'length max variation map factor volume curlLength flyaways material color melanin redness colorVariation thickness taper ' +
    // more of merge
    'sourceKeep targetKeep pose shift turn ' +
    // more built-in models
    'wings key pipes block ' +
    // more of transfer
    'strength keepStretch ' +
    // more of curves
    'base anchor child parent at poses time start end blending encoding guard ownership geodesic gaussian kernel slabs symmetric thesis none ' +
    // more of outputs
    'skin ' +
    // more of curves
    'reach held'
  ).split(' ');
