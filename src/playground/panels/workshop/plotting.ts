/** The plotting library and its style, in a part of their own: they are fetched when plots are first opened. */
import 'uplot/dist/uPlot.min.css';

export { default } from 'uplot';
