/** The plotting library and its style, in a separate chunk that is loaded when plots are first opened. */
import 'uplot/dist/uPlot.min.css';

export { default } from 'uplot';
