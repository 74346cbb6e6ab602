'use strict';
// Before anything is painted: the theme that the reader has chosen, if any.
try { const t = localStorage.getItem('mdr-theme'); if (t) document.documentElement.dataset.theme = t; } catch { /* no storage for this page */ }
// The explorer beside these pages may use their fonts.
try { localStorage.setItem('mdr-fonts', new URL('.', location.href).href); } catch { /* no storage for this page */ }
