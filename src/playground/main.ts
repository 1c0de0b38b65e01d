import './page.css';
import { begin } from './page';

begin(document);
