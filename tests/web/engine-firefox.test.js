// @ts-check
// The page in Firefox.

import { ensureFirefox, launchFirefox } from "./support/firefox.js";
import { journey } from "./support/journey.js";

const program = ensureFirefox();
journey("Firefox", program ? () => launchFirefox(program) : null);
