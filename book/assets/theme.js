'use strict';
// Before anything is painted: the theme that the reader has chosen, if any.
try { const t = localStorage.getItem('mdr-theme'); if (t) document.documentElement.dataset.theme = t; } catch { /* no storage for this page */ }
