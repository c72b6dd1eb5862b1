/** Commands that every brush offers, whatever it paints. */
export const BRUSH = ['brush.erase', 'brush.larger', 'brush.smaller'];
